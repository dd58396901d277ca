/** Requesting the evidence for the labels while the evidence tab is open. */

import { effect } from "@preact/signals";
import { engine } from "../../engine";
import { heightSpeedRange } from "../../model/plants/evidence";
import type { Part } from "../../model/types";
import { type ClipSession, session } from "../../store/clip-session";
import { reportFailure } from "../../store/errors";
import { chosenPart, evidence, evidencePart, pointedFrame } from "../../store/evidence";
import { latestOnly } from "../../util/latest-only";

export function chooseEvidencePart(part: Part) {
  chosenPart.value = part;
}

const request = latestOnly(
  async ({ part, clipSession }: { part: Part; clipSession: ClipSession }) => {
    const tracks = clipSession.detection.value?.parts[part];
    if (!tracks || clipSession.signal.aborted) return;
    try {
      const answer = await clipSession.run("evidence", () =>
        engine.evidence(part, heightSpeedRange(tracks)),
      );
      // May belong to newer labels, which the page is about to receive, while a slider moves.
      if (answer) clipSession.evidence.value = answer;
    } catch (error) {
      reportFailure("explained", clipSession.source?.name ?? "", error, () =>
        request({ part, clipSession }),
      );
    }
  },
);

/** Updates the evidence when the labels change, until the returned function is called. */
export function trackEvidence(): () => void {
  const stop = effect(() => {
    const clipSession = session.value;
    const part = evidencePart.value;
    if (!clipSession.detection.value || !part) {
      clipSession.drop("evidence");
      clipSession.evidence.value = null;
    } else request({ part, clipSession });
  });
  return () => {
    stop();
    pointedFrame.value = null;
    evidence.value = null;
  };
}
