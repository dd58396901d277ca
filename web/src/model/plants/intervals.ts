/** Sorted, disjoint frame intervals: start, end, start, end, …; half-open. */

import { firstIndexWhere } from "../../util/binary-search";

/** Returns the index of the interval that contains a frame, or −1. */
export function intervalAt(intervals: Uint32Array, frame: number): number {
  let low = 0;
  let high = intervals.length / 2 - 1;
  while (low <= high) {
    const middle = (low + high) >> 1;
    if (frame < (intervals[2 * middle] ?? 0)) high = middle - 1;
    else if (frame >= (intervals[2 * middle + 1] ?? 0)) low = middle + 1;
    else return 2 * middle;
  }
  return -1;
}

/** Returns the index of the first interval that ends after a frame. */
export function firstIntervalAfter(intervals: Uint32Array, frame: number): number {
  const isAfter = (i: number) => (intervals[2 * i + 1] as number) > frame;
  return 2 * firstIndexWhere(intervals.length / 2, isAfter);
}

/** Returns the intervals of frames for which a predicate is true. */
export function rangesWhere(frames: number, predicate: (frame: number) => boolean): Uint32Array {
  const ranges: number[] = [];
  pushRanges(ranges, 0, frames, predicate);
  return Uint32Array.from(ranges);
}

/** Appends the intervals of the frames `first` to `end` for which a predicate is true. */
export function pushRanges(
  ranges: number[],
  first: number,
  end: number,
  predicate: (frame: number) => boolean,
) {
  let start = -1;
  for (let i = first; i <= end; i++) {
    const inside = i < end && predicate(i);
    if (inside && start < 0) start = i;
    if (!inside && start >= 0) {
      ranges.push(start, i);
      start = -1;
    }
  }
}
