import type uPlot from "uplot";
import type { FootFrame } from "../model/plants/evidence";
import type { CanvasTheme } from "../ui/canvas-theme";
import { drawPath } from "../util/draw-path";

/** Contents of a plot, and the positions of samples in it. */
export interface PlotData {
  /** x and y of the curve. */
  data: uPlot.AlignedData;
  /** Greatest x and y; both axes start at 0. */
  max: { x: number; y: number };
  /** Draws everything but the curve, in device pixels. */
  paint(plot: uPlot, theme: CanvasTheme): void;
  /** Returns the position of a sample, in axis units; undefined if the sample was excluded. */
  position(sample: FootFrame): { x: number; y: number } | undefined;
  /** Returns the sample nearest to a position, in CSS pixels of the plot. */
  nearest(plot: uPlot, left: number, top: number): FootFrame | undefined;
  /** Returns the sample to which a key moves from another sample. */
  move(from: FootFrame, by: Move): FootFrame;
  /** A draggable horizontal line. */
  dragLine?: { value: number; label: string; onDrag: (value: number) => void };
}

/** Moves by keys between samples. */
export type Move = "previous" | "next" | "first" | "last" | "other-foot";

/** Title, axes and scales of a plot. */
export interface PlotSpec {
  name: string;
  height: number;
  /** Uses square-root scales, which enlarge small values. */
  hasSqrtAxes?: boolean;
  x: Axis;
  y: Axis;
}

interface Axis {
  /** Formats the ticks. */
  values: (values: number[]) => string[];
  /** True if the plot below shows the same axis. */
  hidden?: boolean;
  /** Size of the axis, in pixels. */
  size: number;
}

/** Draws a line across the plot at a value of one axis. */
export function paintLine(
  plot: uPlot,
  axis: "x" | "y",
  value: number,
  color: string,
  isDashed = false,
) {
  const { ctx, bbox } = plot;
  const ratio = devicePixelRatio;
  const position = Math.round(plot.valToPos(value, axis, true));
  ctx.save();
  ctx.setLineDash(isDashed ? [4 * ratio, 3 * ratio] : []);
  ctx.beginPath();
  if (axis === "x") {
    ctx.moveTo(position, bbox.top);
    ctx.lineTo(position, bbox.top + bbox.height);
  } else {
    ctx.moveTo(bbox.left, position);
    ctx.lineTo(bbox.left + bbox.width, position);
  }
  drawPath(ctx, color, 1.5 * ratio);
  ctx.restore();
}

/** Draws a text with an outline in the background colour, legible over points and lines. */
export function paintText(
  { ctx }: uPlot,
  theme: CanvasTheme,
  text: string,
  x: number,
  y: number,
  align: CanvasTextAlign,
  color = theme.accent,
) {
  const ratio = devicePixelRatio;
  ctx.save();
  ctx.font = `550 ${11.5 * ratio}px "Inter Variable", system-ui, sans-serif`;
  ctx.textAlign = align;
  ctx.textBaseline = "middle";
  ctx.lineJoin = "round";
  ctx.lineWidth = 4 * ratio;
  ctx.strokeStyle = theme.background;
  ctx.strokeText(text, x, y);
  ctx.fillStyle = color;
  ctx.fillText(text, x, y);
  ctx.restore();
}
