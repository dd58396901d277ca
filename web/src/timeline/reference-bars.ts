import { rangesWhere } from "../model/intervals";
import type { CanvasTheme } from "../ui/canvas-theme";
import { drawPath } from "../util/draw-path";
import type { ReferenceBars } from "./layout";
import type { Scene } from "./scene";
import { truncateText } from "./text";
import { forEachVisible } from "./visible-intervals";

interface LabelIntervals {
  planted: Uint32Array;
  unknown: Uint32Array;
}

/** Cache of `labelIntervals`. */
const cache = new WeakMap<Int8Array, LabelIntervals>();

/** Returns the intervals of planted frames and of frames without a label. */
function labelIntervals(labels: Int8Array): LabelIntervals {
  let result = cache.get(labels);
  if (!result) {
    result = {
      planted: rangesWhere(labels.length, (i) => labels[i] === 1),
      unknown: rangesWhere(labels.length, (i) => labels[i] === -1),
    };
    cache.set(labels, result);
  }
  return result;
}

/** Draws the plants of the reference as outlines, unlike detected plants. */
export function paintReference(
  ctx: CanvasRenderingContext2D,
  { view, theme }: Scene,
  lane: ReferenceBars,
  laneWidth: number,
) {
  const { planted, unknown } = labelIntervals(lane.labels);
  const forEachInterval = (intervals: Uint32Array, draw: (x: number, width: number) => void) =>
    forEachVisible(intervals, view, laneWidth, (from, to) =>
      draw(from, Math.max(2, to - from - 1)),
    );
  ctx.fillStyle = theme.unknown;
  forEachInterval(unknown, (x, width) => ctx.fillRect(x, lane.y + 2, width, lane.height - 4));
  ctx.fillStyle = theme.tint[lane.side];
  forEachInterval(planted, (x, width) => {
    ctx.beginPath();
    ctx.roundRect(x + 0.5, lane.y + 0.5, Math.max(1, width - 1), lane.height - 1, 2);
    ctx.fill();
    drawPath(ctx, theme[lane.side], 1);
  });
}

/** Draws the name of the reference in the label column, truncated at the lane. */
export function paintReferenceName(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  name: string,
  { y, height }: { y: number; height: number },
  left: number,
  right: number,
) {
  const text = truncateText(ctx, theme, name.replace(/\.(json|csv|bvh)$/i, ""), right - left, 10);
  ctx.fillStyle = theme.muted;
  ctx.fillText(text, left, y + height / 2 + 0.5);
}
