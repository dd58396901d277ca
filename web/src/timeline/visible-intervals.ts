import { firstIntervalAfter } from "../model/intervals";
import { type TimeView, toX } from "../model/time-view";

/** Narrower than this many pixels, and nearer to each other than `near`, intervals are a crowd. */
const narrow = 2;
const near = 1;

/**
 * Hands over the intervals in sight (start, end, start, end …) from left to right in pixels.
 * A crowd is handed over as one, so that a lane costs as much to draw as it is wide,
 * however long the clip.
 */
export function forEachVisible(
  intervals: Uint32Array,
  view: TimeView,
  width: number,
  draw: (from: number, to: number, isCrowd: boolean) => void,
) {
  // Compared in frames: of a crowd, only the ends are turned into pixels.
  const perPixel = (view.end - view.start) / width;
  const [short, close] = [narrow * perPixel, near * perPixel];
  let from = 0;
  let to = Number.NEGATIVE_INFINITY;
  let count = 0;
  let isNarrow = false;
  const hand = () => {
    if (count) draw(toX(view, from, width), toX(view, to, width), count > 1);
  };
  for (let i = firstIntervalAfter(intervals, view.start); i < intervals.length; i += 2) {
    const start = intervals[i] as number;
    if (start > view.end) break;
    const end = intervals[i + 1] as number;
    if (isNarrow && end - start < short && start - to < close) {
      to = end;
      count++;
      continue;
    }
    hand();
    from = start;
    to = end;
    count = 1;
    isNarrow = end - start < short;
  }
  hand();
}
