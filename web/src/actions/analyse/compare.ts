/** Comparing labels and segments with those of a reference. */

import { batch } from "@preact/signals";
import { Cancelled, engine } from "../../engine";
import { failureOf } from "../../model/failure";
import { nextDisagreement } from "../../model/plants/disagreements";
import type { Source } from "../../model/sources/source";
import { type ClipSession, session } from "../../store/clip-session";
import { reportOpenFailure } from "../../store/errors";
import { frame } from "../../store/playback";
import { openClip, score, source } from "../../store/session";
import { showToast } from "../../store/toasts";
import { activeTab, announce, showTab } from "../../store/view";
import { formatBytes, spokenRange } from "../../util/format";
import { fetchBlob } from "../open/fetch-blob";
import { pause, seek } from "../view/playback";

/** Larger than the labels of an hour at 240 Hz. */
const maxReferenceBytes = 2 ** 27;

/** Reads reference labels or segments of the open clip, and compares with them in their tab. */
export async function compareWith(name: string, data: Blob, show = showTab): Promise<void> {
  const clipSession = session.value;
  if (!openClip.value) {
    reportOpenFailure(name, {
      message: "There is no open clip to compare these labels with.",
      hint: "Open the clip first, or drop both together.",
    });
    return;
  }
  if (data.size > maxReferenceBytes) {
    reportOpenFailure(name, {
      message: `The labels have ${formatBytes(data.size)}; the limit is ${formatBytes(maxReferenceBytes)}.`,
    });
    return;
  }
  try {
    const compared = await clipSession.run("compare", () => engine.compare(data, name));
    if (!compared) return;
    if (!compared.ok) {
      reportOpenFailure(name, compared.failure, {
        retry: () => void compareWith(name, data, show),
      });
      return;
    }
    batch(() => {
      if ("segments" in compared) {
        clipSession.referenceSegments.value = compared.segments;
        show("segment");
      } else {
        clipSession.reference.value = compared.annotation;
        show("score");
      }
      announce(`Compared with ${name}`);
    });
    await ("segments" in compared ? updateCutScores(clipSession) : updateScores(clipSession));
  } catch (error) {
    if (!(error instanceof Cancelled))
      reportOpenFailure(name, failureOf(error), {
        retry: () => void compareWith(name, data, show),
      });
  }
}

/** Compares with files in turn, as long as the clip is open, and shows the notices on them. */
export async function compareWithAll(labels: readonly Source[], show = showTab): Promise<void> {
  const { signal } = session.value;
  for (const { name, data, notices = [] } of labels) {
    if (signal.aborted) return;
    for (const { text } of notices) showToast({ text });
    await compareWith(name, data, show);
  }
}

/** Compares a clip that is opened again or from the table, without raising a lowered sheet. */
export const compareQuietly = ({ labels = [] }: Source) =>
  compareWithAll(labels, (tab) => {
    activeTab.value = tab;
  });

/** Compares a sample with the labels that were generated with it. */
export async function compareWithTruth(): Promise<void> {
  const url = source.value?.truthUrl;
  if (!url) return;
  const name = `${openClip.value?.name.replace(/\.bvh$/i, "")} truth`;
  const { signal } = session.value;
  try {
    const data = await fetchBlob(url, signal, maxReferenceBytes, () => {});
    if (!signal.aborted) await compareWith(name, data);
  } catch (error) {
    if (!signal.aborted) reportOpenFailure(name, failureOf(error));
  }
}

/** Removes the reference labels. */
export function removeReference() {
  const clipSession = session.value;
  batch(() => {
    clipSession.reference.value = null;
    clipSession.scorePart.value = null;
    clipSession.scores.value = [];
    clipSession.drop("score");
    if (activeTab.value === "score") activeTab.value = "labels";
  });
}

/** Computes the agreement with the reference labels again; without labels or reference it is empty. */
export async function updateScores(clipSession: ClipSession): Promise<void> {
  const isComparable = clipSession.detection.value && clipSession.reference.value;
  const scores = await clipSession.run("score", async () => (isComparable ? engine.score() : []));
  if (scores) clipSession.scores.value = scores;
}

/** Computes the agreement with the reference segments again. */
export async function updateCutScores(clipSession: ClipSession): Promise<void> {
  const isComparable = clipSession.segmentation.value && clipSession.referenceSegments.value;
  const scores = await clipSession.run("cut score", async () =>
    isComparable ? engine.scoreSegments() : [],
  );
  if (scores) clipSession.cutScores.value = scores;
}

/** Removes the reference segments. */
export function removeReferenceSegments() {
  const clipSession = session.value;
  batch(() => {
    clipSession.referenceSegments.value = null;
    clipSession.cutScores.value = [];
    clipSession.drop("cut score");
  });
}

/** Goes to the next or previous disagreement, wrapping around at the ends. */
export function stepDisagreement(direction: 1 | -1) {
  const next = nextDisagreement(score.value?.disagreements ?? [], frame.value, direction);
  if (!next) return;
  pause();
  seek(next.start);
  announce(
    `${next.side} ${next.part} ${next.kind === "missed" ? "false negative" : "false positive"}, ${spokenRange(next)}`,
  );
}
