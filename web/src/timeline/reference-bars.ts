import { rangesWhere } from "../model/plants/intervals";
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

/** Draws the plants of the reference as outlines, and a line under frames in which the labels differ. */
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
  if (!lane.track) return;
  ctx.fillStyle = theme.difference;
  forEachInterval(differences(lane.labels, lane.track.planted), (x, width) =>
    ctx.fillRect(x, lane.y + lane.height - 2, width, 3),
  );
}

/** Cache of `differences`. */
const differenceCache = new WeakMap<Uint8Array, { labels: Int8Array; ranges: Uint32Array }>();

/** Returns the intervals in which labels differ from those of the reference. */
function differences(labels: Int8Array, planted: Uint8Array): Uint32Array {
  const cached = differenceCache.get(planted);
  if (cached?.labels === labels) return cached.ranges;
  const differs = (i: number) => labels[i] !== -1 && labels[i] !== planted[i];
  const ranges = rangesWhere(labels.length, differs);
  differenceCache.set(planted, { labels, ranges });
  return ranges;
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
