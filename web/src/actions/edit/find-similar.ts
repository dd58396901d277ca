/** Searches for motion to which the edits of plants apply as well. */

import { engine } from "../../engine";
import { plantEditsOf } from "../../model/segments/cut-edits";
import type { ClipSession } from "../../store/clip-session";

/** Updates the offer to apply the edits to similar plants. Call it when the labels or the edits have changed. */
export async function findSimilar(clipSession: ClipSession): Promise<void> {
  const { edits, detection } = clipSession;
  clipSession.similar.value = null;
  const [before, detected] = [edits.value, detection.value];
  if (!plantEditsOf(before).length || clipSession.isSimilarSettled || !detected) return;
  const found = await clipSession.run("similar motion", () => engine.similar());
  const isCurrent = edits.value === before && detection.value === detected;
  if (found?.plants && isCurrent) clipSession.similar.value = found;
}
