import { type TimeView, toX } from "../model/motion/time-view";
import { firstIntervalAfter } from "../model/plants/intervals";

/** Consecutive intervals narrower than `minWidth` with gaps below `minGap` pixels are merged. */
const minWidth = 2;
const minGap = 1;

/**
 * Calls `draw` with the pixel range of each visible interval (start, end, start, end …), from left to
 * right. Merges dense intervals, so that the cost depends on the width of the lane and not on the
 * length of the clip.
 */
export function forEachVisible(
  intervals: Uint32Array,
  view: TimeView,
  width: number,
  draw: (from: number, to: number, isMerged: boolean) => void,
) {
  // Compared in frames, which avoids converting every interval to pixels.
  const framesPerPixel = (view.end - view.start) / width;
  const [minFrames, minGapFrames] = [minWidth * framesPerPixel, minGap * framesPerPixel];
  let from = 0;
  let to = Number.NEGATIVE_INFINITY;
  let count = 0;
  let isNarrow = false;
  const flush = () => {
    if (count) draw(toX(view, from, width), toX(view, to, width), count > 1);
  };
  for (let i = firstIntervalAfter(intervals, view.start); i < intervals.length; i += 2) {
    const start = intervals[i] as number;
    if (start > view.end) break;
    const end = intervals[i + 1] as number;
    if (isNarrow && end - start < minFrames && start - to < minGapFrames) {
      to = end;
      count++;
      continue;
    }
    flush();
    from = start;
    to = end;
    count = 1;
    isNarrow = end - start < minFrames;
  }
  flush();
}
