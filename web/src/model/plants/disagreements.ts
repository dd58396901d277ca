import type { Disagreement } from "../types";

/**
 * Returns the first disagreement that starts after a frame, or the last that starts before it. Wraps
 * around at the ends of the list.
 */
export function nextDisagreement(
  list: readonly Disagreement[],
  frame: number,
  direction: 1 | -1,
): Disagreement | undefined {
  return direction > 0
    ? (list.find(({ start }) => start > frame) ?? list[0])
    : (list.findLast(({ start }) => start < frame) ?? list.at(-1));
}
