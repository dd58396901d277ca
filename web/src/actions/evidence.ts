/** Requesting the evidence for the labels while the evidence tab is open. */

import { effect } from "@preact/signals";
import { Cancelled, engine } from "../engine";
import { heightSpeedRange } from "../model/evidence";
import type { Part } from "../model/types";
import { type ClipSession, session } from "../store/clip-session";
import { reportFailure } from "../store/errors";
import { chosenPart, evidence, evidencePart, pointedFrame } from "../store/evidence";
import { latestOnly } from "../util/latest-only";

export function chooseEvidencePart(part: Part) {
  chosenPart.value = part;
}

const request = latestOnly(async ({ part, open }: { part: Part; open: ClipSession }) => {
  const tracks = open.detection.value?.parts[part];
  if (!tracks || open.signal.aborted) return;
  try {
    const answer = await open.run("evidence", () =>
      engine.evidence(part, heightSpeedRange(tracks)),
    );
    // While a slider moves, the worker may already have the next labels; those are on their way.
    if (answer) open.evidence.value = answer;
  } catch (error) {
    if (!(error instanceof Cancelled)) reportFailure("explained", open.source?.name ?? "", error);
  }
});

/** Keeps the evidence up to date with the labels until the returned function is called. */
export function trackEvidence(): () => void {
  const stop = effect(() => {
    const open = session.value;
    const part = evidencePart.value;
    if (!open.detection.value || !part) {
      open.drop("evidence");
      open.evidence.value = null;
    } else request({ part, open });
  });
  return () => {
    stop();
    pointedFrame.value = null;
    evidence.value = null;
  };
}
