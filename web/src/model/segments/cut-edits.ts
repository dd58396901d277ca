/** Edits of the cuts between segments, and lists that mix them with edits of plants. */

import type { CutEdit, Edit } from "../types";

/** An edit of the labels or of the cuts. */
export type AnyEdit = Edit | CutEdit;

export const isCutEdit = (edit: AnyEdit): edit is CutEdit => "cut" in edit;

/** Returns the edits of plants, in order. */
export const plantEditsOf = (edits: readonly AnyEdit[]): Edit[] =>
  edits.filter((edit): edit is Edit => !isCutEdit(edit));

/** Returns the edits of cuts, in order. */
export const cutEditsOf = (edits: readonly AnyEdit[]): CutEdit[] => edits.filter(isCutEdit);

/** True if two lists differ at most in their edits of cuts. */
export const haveSamePlantEdits = (a: readonly AnyEdit[], b: readonly AnyEdit[]): boolean =>
  JSON.stringify(plantEditsOf(a)) === JSON.stringify(plantEditsOf(b));

/** Returns edits that move a cut between its neighbours; none if it stays. */
export function moveCut(
  cuts: readonly number[],
  from: number,
  to: number,
  frames: number,
): CutEdit[] {
  const index = cuts.indexOf(from);
  if (index < 0) return [];
  const low = (cuts[index - 1] ?? 0) + 1;
  const high = (cuts[index + 1] ?? frames) - 1;
  const limited = Math.min(Math.max(Math.round(to), low), high);
  if (limited === from) return [];
  return [
    { cut: from, present: false },
    { cut: limited, present: true },
  ];
}

/** Returns the edit that adds a cut; none at the ends of the clip and where there is one. */
export function addCut(cuts: readonly number[], frame: number, frames: number): CutEdit[] {
  return frame > 0 && frame < frames && !cuts.includes(frame)
    ? [{ cut: frame, present: true }]
    : [];
}

/** Returns the edit that removes a cut. */
export const removeCut = (cut: number): CutEdit[] => [{ cut, present: false }];

/** Returns the cut that is nearest to a frame, if there is any. */
export function nearestCut(cuts: readonly number[], frame: number): number | undefined {
  const distance = (cut: number) => Math.abs(cut - frame);
  return cuts.reduce<number | undefined>(
    (best, cut) => (best === undefined || distance(cut) < distance(best) ? cut : best),
    undefined,
  );
}
