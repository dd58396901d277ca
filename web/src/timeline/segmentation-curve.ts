import { toX } from "../model/time-view";
import type { Curve } from "../model/types";
import { quantile } from "../util/min-max-pyramid";
import type { SegmentLane } from "./layout";
import type { Scene } from "./scene";

interface Range {
  low: number;
  top: number;
}

const ranges = new WeakMap<Curve, Range>();

/** One spike must not flatten a curve, but what it is compared with is always in sight. */
function rangeOf(curve: Curve): Range {
  let range = ranges.get(curve);
  if (!range) {
    const top = Math.max(quantile(curve.values, 0.995), quantile(curve.threshold, 0.98));
    const low = Math.min(0, quantile(curve.values, 0.005));
    range = { low, top: top > low ? low + 1.06 * (top - low) : low + 1 };
    ranges.set(curve, range);
  }
  return range;
}

/** What the method looks at: its curve, what that is compared with, where it turns, and the cuts. */
export function paintSegmentationCurve(
  pen: CanvasRenderingContext2D,
  scene: Scene,
  lane: SegmentLane,
  inner: number,
) {
  const { ink, view, segmentation, namedSegments } = scene;
  pen.fillStyle = ink.lane;
  pen.fillRect(0, lane.y, inner, lane.height);
  if (!segmentation) return;
  const { curve } = segmentation;
  const { low, top } = rangeOf(curve);
  const bottom = lane.y + lane.height - 4;
  const scale = (lane.height - 8) / (top - low);
  pen.save();
  pen.beginPath();
  pen.rect(0, lane.y, inner, lane.height);
  pen.clip();
  pen.fillStyle = ink.edge;
  for (const { start } of namedSegments) {
    if (start === 0 || start < view.start || start > view.end) continue;
    pen.fillRect(Math.round(toX(view, start, inner)) - 1, lane.y, 1, lane.height);
  }
  pen.lineJoin = "round";
  if (curve.threshold.length) {
    trace(pen, scene, curve.frames, curve.threshold, inner, bottom, scale, low);
    pen.setLineDash(dashes);
    pen.strokeStyle = ink.accent;
    pen.lineWidth = 1.25;
    pen.stroke();
    pen.setLineDash(solid);
  }
  trace(pen, scene, curve.frames, curve.values, inner, bottom, scale, low);
  pen.strokeStyle = ink.text;
  pen.lineWidth = 1.5;
  pen.stroke();
  dots(pen, scene, curve, inner, bottom, scale, low);
  pen.restore();
}

const dashes = [4, 3];
const solid: number[] = [];

/** Place of the last value that lies before a frame, or of the first. */
function before(frames: Float32Array, frame: number): number {
  let low = 0;
  let high = frames.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((frames[middle] as number) < frame) low = middle + 1;
    else high = middle;
  }
  return Math.max(0, low - 1);
}

/**
 * A path through values; where many fall on one pixel, from the least of them to the greatest.
 * Methods that begin anew after a cut have no values for a while.
 */
function trace(
  pen: CanvasRenderingContext2D,
  { view }: Scene,
  frames: Float32Array,
  values: Float32Array,
  inner: number,
  bottom: number,
  scale: number,
  low: number,
) {
  const gap = 1.9 * ((frames[1] ?? 0) - (frames[0] ?? 0)) + 0.01;
  const perPixel = (view.end - view.start) / inner;
  const yOf = (value: number) => bottom - (value - low) * scale;
  let column = 0;
  /** The frame with which the next column begins. */
  let edge = Number.NEGATIVE_INFINITY;
  let min = 0;
  let max = 0;
  const span = () => {
    if (min === max) return;
    pen.lineTo(column + 0.5, yOf(max));
    pen.lineTo(column + 0.5, yOf(min));
  };
  pen.beginPath();
  for (let i = before(frames, view.start); i < values.length; i++) {
    const frame = frames[i] as number;
    const value = values[i] as number;
    if (frame < edge) {
      if (value < min) min = value;
      else if (value > max) max = value;
      continue;
    }
    span();
    const x = toX(view, frame, inner);
    if (i > 0 && frame - (frames[i - 1] as number) > gap) pen.moveTo(x, yOf(value));
    else pen.lineTo(x, yOf(value));
    if (x > inner) return;
    column = Math.floor(x);
    edge = view.start + (column + 1) * perPixel;
    min = value;
    max = value;
  }
  span();
}

/** The turning points, where they stand apart. */
function dots(
  pen: CanvasRenderingContext2D,
  { view, ink }: Scene,
  { frames, values, extrema }: Curve,
  inner: number,
  bottom: number,
  scale: number,
  low: number,
) {
  const [first, last] = [extrema[0], extrema.at(-1)];
  if (first === undefined || last === undefined || extrema.length < 2) return;
  const span = (frames[last] as number) - (frames[first] as number);
  const apart = (span / extrema.length / (view.end - view.start)) * inner;
  if (apart < 5) return;
  const radius = apart < 12 ? 1.75 : 2.5;
  pen.fillStyle = ink.accent;
  pen.strokeStyle = ink.lane;
  pen.lineWidth = 1;
  for (const index of extrema) {
    const at = frames[index] as number;
    if (at < view.start || at > view.end) continue;
    const y = bottom - ((values[index] as number) - low) * scale;
    pen.beginPath();
    pen.arc(toX(view, at, inner), y, radius, 0, 7);
    pen.fill();
    pen.stroke();
  }
}
