/** Applies the edits of the cuts to the segments. */

import { batch } from "@preact/signals";
import { engine } from "../../engine";
import { cutEditsOf } from "../../model/segments/cut-edits";
import type { Segment } from "../../model/types";
import type { ClipSession } from "../../store/clip-session";
import { updateCutScores } from "../analyse/compare";

/** The edits that were applied to a segmentation, as text. */
const applied = new WeakMap<object, string>();

/** Applies the edits of the cuts to the segmentation, if there is one and they have changed. */
export async function applyCutEdits(clipSession: ClipSession): Promise<void> {
  const before = clipSession.segmentation.value;
  const edits = cutEditsOf(clipSession.edits.value);
  const key = JSON.stringify(edits);
  if (!before || key === (applied.get(before) ?? "[]")) return;
  const segments = await clipSession.run("edit cuts", () => engine.editCuts(edits));
  const current = clipSession.segmentation.value;
  if (!segments || !current) return;
  const after = { ...current, segments, detected: current.detected ?? current.segments };
  applied.set(after, key);
  batch(() => {
    clipSession.segmentation.value = after;
    followCut(clipSession, current.segments);
  });
  await updateCutScores(clipSession);
}

/** If the selected cut no longer exists, selects the only new one: that to which it was moved. */
function followCut({ selectedCut, segmentation }: ClipSession, before: readonly Segment[]) {
  const cut = selectedCut.value;
  const segments = segmentation.value?.segments ?? [];
  if (cut === null || segments.some(({ start }) => start === cut)) return;
  const [added, ...others] = segments.filter(
    ({ start }) => !before.some((segment) => segment.start === start),
  );
  selectedCut.value = added && !others.length ? added.start : null;
}
