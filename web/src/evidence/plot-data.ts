import type uPlot from "uplot";
import type { FootFrame } from "../model/evidence";
import type { CanvasTheme } from "../ui/canvas-theme";

/** What one plot shows of the evidence, and where in it each sample lies. */
export interface PlotData {
  /** x, and y where there is a curve. */
  data: uPlot.AlignedData;
  /** The greatest x and y; both begin at 0. */
  top: { x: number; y: number };
  /** Draws what is no curve: before that is over, in pixels of the canvas. */
  paint(plot: uPlot, ink: CanvasTheme): void;
  /** Where a sample lies, in units of the axes. */
  place(sample: FootFrame): { x: number; y: number } | undefined;
  /** The sample closest to a place, in pixels of the plot. */
  nearest(plot: uPlot, left: number, top: number): FootFrame | undefined;
  /** Where a key leads from a sample. */
  step(from: FootFrame, by: Step): FootFrame;
  /** A level that can be dragged. */
  level?: { at: number; text: string; set: (to: number) => void };
}

export type Step = "back" | "on" | "first" | "last" | "other";

/** Axes and scales of one kind of plot. */
export interface PlotSpec {
  name: string;
  height: number;
  /** Axes whose numbers stand closer near 0. */
  square?: boolean;
  x: Axis;
  y: Axis;
}

interface Axis {
  values: (values: number[]) => string[];
  /** Hidden where the plot below has the same. */
  hidden?: boolean;
  size: number;
}

/** A line across the plot at a value of one axis. */
export function paintLine(
  plot: uPlot,
  axis: "x" | "y",
  value: number,
  color: string,
  dash = false,
) {
  const { ctx, bbox } = plot;
  const ratio = devicePixelRatio;
  const at = Math.round(plot.valToPos(value, axis, true));
  ctx.save();
  ctx.strokeStyle = color;
  ctx.lineWidth = 1.5 * ratio;
  ctx.setLineDash(dash ? [4 * ratio, 3 * ratio] : []);
  ctx.beginPath();
  if (axis === "x") {
    ctx.moveTo(at, bbox.top);
    ctx.lineTo(at, bbox.top + bbox.height);
  } else {
    ctx.moveTo(bbox.left, at);
    ctx.lineTo(bbox.left + bbox.width, at);
  }
  ctx.stroke();
  ctx.restore();
}

/** A word on the plot with the ground behind it, so that it reads over dots and lines. */
export function paintText(
  { ctx }: uPlot,
  ink: CanvasTheme,
  text: string,
  x: number,
  y: number,
  align: CanvasTextAlign,
  color = ink.accent,
) {
  const ratio = devicePixelRatio;
  ctx.save();
  ctx.font = `550 ${11.5 * ratio}px "Inter Variable", system-ui, sans-serif`;
  ctx.textAlign = align;
  ctx.textBaseline = "middle";
  ctx.lineJoin = "round";
  ctx.lineWidth = 4 * ratio;
  ctx.strokeStyle = ink.ground;
  ctx.strokeText(text, x, y);
  ctx.fillStyle = color;
  ctx.fillText(text, x, y);
  ctx.restore();
}
