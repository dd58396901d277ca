/** Applies the edits of the cuts to the segments. */

import { engine } from "../../engine";
import { cutEditsOf } from "../../model/segments/cut-edits";
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
  const after = { ...current, segments };
  applied.set(after, key);
  clipSession.segmentation.value = after;
  await updateCutScores(clipSession);
}
