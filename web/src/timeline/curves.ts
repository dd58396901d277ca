import { toX } from "../model/time-view";
import { niceCeiling } from "../util/axis-steps";
import { minMaxColumns } from "../util/min-max-pyramid";
import type { Curves } from "./layout";
import type { Scene } from "./scene";

/** Of a curve, in pixels. */
const thickness = 1.5;

let columns = new Float32Array(0);

function laneTop({ left, right, kind }: Curves): number {
  return niceCeiling(Math.max(left.summaries[kind].top, right.summaries[kind].top));
}

/** What the curves of a lane show: `Toe height`. */
export function curveText({ part, kind }: Curves): string {
  return `${part.charAt(0).toUpperCase() + part.slice(1)} ${kind}`;
}

/** What the height of the lane stands for. */
export function scaleText(lane: Curves): string {
  const top = laneTop(lane);
  if (lane.kind === "speed") return `0–${Number(top.toPrecision(3))} m/s`;
  return top < 1
    ? `0–${Number((100 * top).toPrecision(3))} cm`
    : `0–${Number(top.toPrecision(3))} m`;
}

export function paintCurves(
  pen: CanvasRenderingContext2D,
  scene: Scene,
  lane: Curves,
  inner: number,
) {
  const { ink, view } = scene;
  pen.fillStyle = ink.lane;
  pen.fillRect(0, lane.y, inner, lane.height);
  const top = laneTop(lane);
  const n = Math.max(1, Math.floor(inner));
  if (columns.length < 2 * n) columns = new Float32Array(2 * n);
  const low = lane.y + lane.height - 3;
  const scale = (lane.height - 6) / top;
  pen.save();
  pen.beginPath();
  pen.rect(0, lane.y, inner, lane.height);
  pen.clip();
  const isNear = view.end - view.start < n;
  for (const side of ["right", "left"] as const) {
    pen.beginPath();
    if (isNear) {
      traceFrames(pen, scene, lane[side][lane.kind], inner, low, scale);
      pen.strokeStyle = ink[side];
      pen.lineWidth = thickness;
      pen.lineJoin = "round";
      pen.stroke();
    } else {
      const { [lane.kind]: values, summaries } = lane[side];
      minMaxColumns(values, summaries[lane.kind].extremes, view.start, view.end, n, columns);
      traceColumns(pen, n, low, scale, top);
      pen.fillStyle = ink[side];
      pen.fill();
    }
  }
  pen.restore();
}

/** Close by, a curve goes from frame to frame. */
function traceFrames(
  pen: CanvasRenderingContext2D,
  { view }: Scene,
  values: Float32Array,
  inner: number,
  low: number,
  scale: number,
) {
  const last = Math.min(values.length - 1, Math.ceil(view.end));
  for (let f = Math.max(0, Math.floor(view.start)); f <= last; f++) {
    pen.lineTo(toX(view, f, inner), low - (values[f] as number) * scale);
  }
}

/**
 * From afar, each column spans from its least to its greatest value: a band between two lines,
 * which is drawn in half the time of one that goes up and down in every column.
 */
function traceColumns(
  pen: CanvasRenderingContext2D,
  n: number,
  low: number,
  scale: number,
  top: number,
) {
  const most = top * 1.02;
  const upper = low - thickness / 2;
  const lower = low + thickness / 2;
  for (let x = 0; x < n; x++) {
    const value = columns[2 * x + 1] as number;
    pen.lineTo(x + 0.5, upper - (value < most ? value : most) * scale);
  }
  for (let x = n - 1; x >= 0; x--) {
    const value = columns[2 * x] as number;
    pen.lineTo(x + 0.5, lower - (value < most ? value : most) * scale);
  }
}
