/** Editing the cuts between segments; undone together with the edits of plants. */

import { addCut, moveCut, nearestCut, removeCut } from "../model/cut-edits";
import type { CutEdit } from "../model/types";
import { frame } from "../store/playback";
import { clip, cuts, edits, selectedCut } from "../store/session";
import { notify } from "../store/view";
import { commitEdits, select } from "./edit";
import { pause, seek } from "./playback";

const frames = () => clip.value?.frames ?? 0;

/** Selects a cut instead of a plant. */
export function selectCut(cut: number | null) {
  select(undefined);
  selectedCut.value = cut;
}

function commit(added: readonly CutEdit[], message: string, next: number | null): Promise<void> {
  const committed = commitEdits([...edits.value, ...added], message);
  selectCut(next);
  return committed;
}

/** Moves a cut; its new frame is limited by the neighbouring cuts. */
export async function moveCutTo(cut: number, to: number): Promise<void> {
  const moved = moveCut(cuts.value, cut, to, frames());
  const at = moved.at(-1)?.cut;
  if (at === undefined) return;
  pause();
  seek(at);
  await commit(moved, `Cut moved to frame ${at}`, at);
}

let nudging = Promise.resolve();

/** Moves the selected cut by a number of frames. */
export function nudgeCut(by: number): Promise<void> {
  // The segments must contain the previous edit.
  nudging = nudging.then(() => {
    const cut = selectedCut.value;
    return cut === null ? undefined : moveCutTo(cut, cut + by);
  });
  return nudging;
}

/** Adds a cut before the frame at the playhead. */
export function addCutAtPlayhead() {
  const added = addCut(cuts.value, frame.value, frames());
  if (added.length) void commit(added, `Cut added at frame ${frame.value}`, frame.value);
  else notify("There is a cut or an end of the clip at the playhead");
}

/** Removes the selected cut, or else the one nearest to the playhead: two segments become one. */
export function removeNearestCut() {
  const cut = selectedCut.value ?? nearestCut(cuts.value, frame.value);
  if (cut === undefined) notify("There is no cut");
  else void commit(removeCut(cut), `Cut at frame ${cut} removed`, null);
}
