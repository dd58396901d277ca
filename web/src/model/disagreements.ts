import type { Disagreement } from "./types";

/** The disagreement that begins next after (or last before) a frame; beyond the end it starts over. */
export function nextDisagreement(
  list: readonly Disagreement[],
  frame: number,
  direction: 1 | -1,
): Disagreement | undefined {
  return direction > 0
    ? (list.find(({ start }) => start > frame) ?? list[0])
    : (list.findLast(({ start }) => start < frame) ?? list.at(-1));
}
