import { toX } from "../model/motion/time-view";
import { niceCeiling } from "../util/axis-steps";
import { drawPath } from "../util/draw-path";
import { capitalize } from "../util/format";
import { minMaxColumns } from "../util/min-max-pyramid";
import type { Curves } from "./layout";
import type { Scene } from "./scene";

/** Line width of the curves, in pixels. */
const lineWidth = 1.5;

/** Minimum and maximum per pixel column; reused to avoid allocation. */
let columnExtremes = new Float32Array(0);

/**
 * Returns the value at the top of a lane of curves: that of the visible frames, or, for the whole clip, the
 * one that single spikes do not exceed.
 */
function axisMaximum({ left, right, kind }: Curves, { view, frames }: Scene): number {
  const isWhole = view.end - view.start >= frames;
  const tops = [left, right].map(({ [kind]: values, summaries }) => {
    if (isWhole) return summaries[kind].top;
    const { extremes } = summaries[kind];
    return minMaxColumns(values, extremes, view.start, view.end, 1, visibleExtremes)[1] as number;
  });
  return niceCeiling(Math.max(...tops, smallestTop[kind]));
}

/** Smallest range of an axis, so that noise does not fill it: in metres and in m/s. */
const smallestTop = { height: 0.02, speed: 0.1 };

const visibleExtremes = new Float32Array(2);

/** Returns the label of a lane of curves, such as `Toe height`. */
export function curveText({ part, kind }: Curves): string {
  return `${capitalize(part)} ${kind}`;
}

/** Returns the range of the vertical axis, such as `0–20 cm`. */
export function scaleText(lane: Curves, scene: Scene): string {
  const top = axisMaximum(lane, scene);
  if (lane.kind === "speed") return `0–${Number(top.toPrecision(3))} m/s`;
  return top < 1
    ? `0–${Number((100 * top).toPrecision(3))} cm`
    : `0–${Number(top.toPrecision(3))} m`;
}

/** Draws the height or speed curves of both feet. */
export function paintCurves(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  lane: Curves,
  laneWidth: number,
) {
  const { theme, view } = scene;
  ctx.fillStyle = theme.lane;
  ctx.fillRect(0, lane.y, laneWidth, lane.height);
  const top = axisMaximum(lane, scene);
  const columns = Math.max(1, Math.floor(laneWidth));
  if (columnExtremes.length < 2 * columns) columnExtremes = new Float32Array(2 * columns);
  const bottom = lane.y + lane.height - 3;
  const scale = (lane.height - 6) / top;
  ctx.save();
  ctx.beginPath();
  ctx.rect(0, lane.y, laneWidth, lane.height);
  ctx.clip();
  const showsFrames = view.end - view.start < columns;
  for (const side of ["right", "left"] as const) {
    ctx.beginPath();
    if (showsFrames) {
      traceFrames(ctx, scene, lane[side][lane.kind], laneWidth, bottom, scale);
      ctx.lineJoin = "round";
      drawPath(ctx, theme[side], lineWidth);
    } else {
      const { [lane.kind]: values, summaries } = lane[side];
      minMaxColumns(
        values,
        summaries[lane.kind].extremes,
        view.start,
        view.end,
        columns,
        columnExtremes,
      );
      traceColumns(ctx, columns, bottom, scale, top);
      ctx.fillStyle = theme[side];
      ctx.fill();
    }
  }
  ctx.restore();
}

/** Adds a line from frame to frame to the path. */
function traceFrames(
  ctx: CanvasRenderingContext2D,
  { view }: Scene,
  values: Float32Array,
  laneWidth: number,
  bottom: number,
  scale: number,
) {
  const last = Math.min(values.length - 1, Math.ceil(view.end));
  for (let frame = Math.max(0, Math.floor(view.start)); frame <= last; frame++) {
    ctx.lineTo(toX(view, frame, laneWidth), bottom - (values[frame] as number) * scale);
  }
}

/**
 * Adds the band between the column maxima and the column minima to the path. Filling it takes half
 * the time of drawing a line that goes up and down in every column.
 */
function traceColumns(
  ctx: CanvasRenderingContext2D,
  columns: number,
  bottom: number,
  scale: number,
  top: number,
) {
  const limit = top * 1.02;
  const upper = bottom - lineWidth / 2;
  const lower = bottom + lineWidth / 2;
  for (let x = 0; x < columns; x++) {
    const value = columnExtremes[2 * x + 1] as number;
    ctx.lineTo(x + 0.5, upper - (value < limit ? value : limit) * scale);
  }
  for (let x = columns - 1; x >= 0; x--) {
    const value = columnExtremes[2 * x] as number;
    ctx.lineTo(x + 0.5, lower - (value < limit ? value : limit) * scale);
  }
}
