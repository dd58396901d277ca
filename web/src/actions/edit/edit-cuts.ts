/** Editing the cuts between segments; undone together with the edits of plants. */

import { addCut, moveCut, nearestCut, removeCut } from "../../model/segments/cut-edits";
import type { CutEdit } from "../../model/types";
import { frame } from "../../store/playback";
import { clip, cuts, edits, segmentation, selectedCut } from "../../store/session";
import { notify } from "../../store/view";
import { pause, seek } from "../view/playback";
import { commitEdits, inOrder, select } from "./edit";

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
export const moveCutTo = (cut: number, to: number) => inOrder(() => move(cut, to));

async function move(cut: number, to: number): Promise<void> {
  const moved = moveCut(cuts.value, cut, to, frames());
  const at = moved.at(-1)?.cut;
  if (at === undefined) return;
  pause();
  seek(at);
  await commit(moved, `Cut moved to frame ${at}`, at);
}

/** Moves the selected cut by a number of frames. */
export const nudgeCut = (by: number) =>
  inOrder(async () => {
    const cut = selectedCut.value;
    if (cut !== null) await move(cut, cut + by);
  });

/** Adds a cut before the frame at the playhead. */
export function addCutAtPlayhead(): Promise<void> {
  const at = frame.value;
  return inOrder(async () => {
    const added = addCut(cuts.value, at, frames());
    if (!segmentation.value) notify("There are no segments to cut");
    else if (added.length) await commit(added, `Cut added at frame ${at}`, at);
    else notify("No cut was added: the playhead is at a cut or at an end of the clip");
  });
}

/** Removes the selected cut, or else the one nearest to the playhead: two segments become one. */
export function removeNearestCut(): Promise<void> {
  const at = frame.value;
  return inOrder(async () => {
    const cut = selectedCut.value ?? nearestCut(cuts.value, at);
    if (cut === undefined || !cuts.value.includes(cut)) notify("There is no cut to remove");
    else await commit(removeCut(cut), `Cut at frame ${cut} removed`, null);
  });
}
