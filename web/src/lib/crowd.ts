import { firstPast } from "./search";
import { type TimeView, toX } from "./timeView";

/** Narrower than this many pixels, and nearer to each other than `near`, intervals are a crowd. */
const narrow = 2;
const near = 1;

/**
 * Hands over the intervals in sight (start, end, start, end …) from left to right in pixels.
 * A crowd is handed over as one, so that a lane costs as much to draw as it is wide,
 * however long the clip.
 */
export function eachInSight(
  intervals: Uint32Array,
  view: TimeView,
  width: number,
  draw: (from: number, to: number, isCrowd: boolean) => void,
) {
  let from = 0;
  let to = Number.NEGATIVE_INFINITY;
  let count = 0;
  let isNarrow = false;
  for (let i = firstAfter(intervals, view.start); i < intervals.length; i += 2) {
    const start = intervals[i] as number;
    if (start > view.end) break;
    const left = toX(view, start, width);
    const right = toX(view, intervals[i + 1] as number, width);
    if (isNarrow && right - left < narrow && left - to < near) {
      to = right;
      count++;
      continue;
    }
    if (count) draw(from, to, count > 1);
    from = left;
    to = right;
    count = 1;
    isNarrow = right - left < narrow;
  }
  if (count) draw(from, to, count > 1);
}

/** Place of the first interval that ends after a frame. */
export function firstAfter(intervals: Uint32Array, frame: number): number {
  return 2 * firstPast(intervals.length / 2, (i) => (intervals[2 * i + 1] as number) > frame);
}
