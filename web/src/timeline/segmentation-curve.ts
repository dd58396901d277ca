import { toX } from "../model/motion/time-view";
import type { Curve } from "../model/types";
import { firstIndexWhere } from "../util/binary-search";
import { drawPath } from "../util/draw-path";
import { quantile } from "../util/min-max-pyramid";
import type { SegmentLane } from "./layout";
import type { Scene } from "./scene";

interface ValueRange {
  minimum: number;
  maximum: number;
}

/** Cache of `rangeOf`. */
const ranges = new WeakMap<Curve, ValueRange>();

/** Returns the vertical range: quantiles, so that spikes do not flatten the curve, with the threshold. */
function rangeOf(curve: Curve): ValueRange {
  let range = ranges.get(curve);
  if (!range) {
    const maximum = Math.max(quantile(curve.values, 0.995), quantile(curve.threshold, 0.98));
    const minimum = Math.min(0, quantile(curve.values, 0.005));
    range = {
      minimum,
      maximum: maximum > minimum ? minimum + 1.06 * (maximum - minimum) : minimum + 1,
    };
    ranges.set(curve, range);
  }
  return range;
}

/** Draws the curve of the segmentation method with its threshold, its extrema and the cuts. */
export function paintSegmentationCurve(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  lane: SegmentLane,
  laneWidth: number,
) {
  const { theme, view, segmentation, namedSegments } = scene;
  ctx.fillStyle = theme.lane;
  ctx.fillRect(0, lane.y, laneWidth, lane.height);
  if (!segmentation) return;
  const { curve } = segmentation;
  const { minimum, maximum } = rangeOf(curve);
  const bottom = lane.y + lane.height - 4;
  const scale = (lane.height - 8) / (maximum - minimum);
  ctx.save();
  ctx.beginPath();
  ctx.rect(0, lane.y, laneWidth, lane.height);
  ctx.clip();
  ctx.fillStyle = theme.borderStrong;
  for (const { start } of namedSegments) {
    if (start === 0 || start < view.start || start > view.end) continue;
    ctx.fillRect(Math.round(toX(view, start, laneWidth)) - 1, lane.y, 1, lane.height);
  }
  ctx.lineJoin = "round";
  if (curve.threshold.length) {
    addCurvePath(ctx, scene, curve.frames, curve.threshold, laneWidth, bottom, scale, minimum);
    ctx.setLineDash(dashedLine);
    drawPath(ctx, theme.accent, 1.25);
    ctx.setLineDash(solidLine);
  }
  addCurvePath(ctx, scene, curve.frames, curve.values, laneWidth, bottom, scale, minimum);
  drawPath(ctx, theme.text, 1.5);
  paintExtrema(ctx, scene, curve, laneWidth, bottom, scale, minimum);
  ctx.restore();
}

const dashedLine = [4, 3];
const solidLine: number[] = [];

/** Returns the index of the last value before a frame, or 0. */
function indexBefore(frames: Float32Array, frame: number): number {
  const isAtOrAfter = (i: number) => (frames[i] as number) >= frame;
  return Math.max(0, firstIndexWhere(frames.length, isAtOrAfter) - 1);
}

/**
 * Starts a path through the values. Values in one pixel column are reduced to their minimum and
 * maximum. The line is interrupted where values are missing, as after the cuts of some methods.
 */
function addCurvePath(
  ctx: CanvasRenderingContext2D,
  { view }: Scene,
  frames: Float32Array,
  values: Float32Array,
  laneWidth: number,
  bottom: number,
  scale: number,
  minimum: number,
) {
  const maxStep = 1.9 * ((frames[1] ?? 0) - (frames[0] ?? 0)) + 0.01;
  const framesPerPixel = (view.end - view.start) / laneWidth;
  const yOf = (value: number) => bottom - (value - minimum) * scale;
  let column = 0;
  /** First frame of the next pixel column. */
  let nextColumnFrame = Number.NEGATIVE_INFINITY;
  let min = 0;
  let max = 0;
  const finishColumn = () => {
    if (min === max) return;
    ctx.lineTo(column + 0.5, yOf(max));
    ctx.lineTo(column + 0.5, yOf(min));
  };
  ctx.beginPath();
  for (let i = indexBefore(frames, view.start); i < values.length; i++) {
    const frame = frames[i] as number;
    const value = values[i] as number;
    if (frame < nextColumnFrame) {
      if (value < min) min = value;
      else if (value > max) max = value;
      continue;
    }
    finishColumn();
    const x = toX(view, frame, laneWidth);
    if (i > 0 && frame - (frames[i - 1] as number) > maxStep) ctx.moveTo(x, yOf(value));
    else ctx.lineTo(x, yOf(value));
    if (x > laneWidth) return;
    column = Math.floor(x);
    nextColumnFrame = view.start + (column + 1) * framesPerPixel;
    min = value;
    max = value;
  }
  finishColumn();
}

/** Draws the extrema if they are far enough apart. */
function paintExtrema(
  ctx: CanvasRenderingContext2D,
  { view, theme }: Scene,
  { frames, values, extrema }: Curve,
  laneWidth: number,
  bottom: number,
  scale: number,
  minimum: number,
) {
  const [first, last] = [extrema[0], extrema.at(-1)];
  if (first === undefined || last === undefined || extrema.length < 2) return;
  const duration = (frames[last] as number) - (frames[first] as number);
  const meanSpacing = (duration / extrema.length / (view.end - view.start)) * laneWidth;
  if (meanSpacing < 5) return;
  const radius = meanSpacing < 12 ? 1.75 : 2.5;
  ctx.fillStyle = theme.accent;
  for (const index of extrema) {
    const frame = frames[index] as number;
    if (frame < view.start || frame > view.end) continue;
    const y = bottom - ((values[index] as number) - minimum) * scale;
    ctx.beginPath();
    ctx.arc(toX(view, frame, laneWidth), y, radius, 0, 7);
    ctx.fill();
    drawPath(ctx, theme.lane, 1);
  }
}
