import type uPlot from "uplot";
import { type FootFrame, heightSpeedRange, sides } from "../model/plants/evidence";
import { formatValue } from "../model/plants/explanation";
import type { Evidence, Tracks } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import { drawPath } from "../util/draw-path";
import { contour } from "./contour";
import { type PlotData, type PlotSpec, paintLine, paintText } from "./plot-data";

/** Greatest number of points per foot; frames are skipped in longer clips. */
const maxPoints = 2000;

/** Greatest distance from the pointer at which a point is selected, in pixels. */
const maxDistance = 24;

export const scatterSpec: PlotSpec = {
  name: "Height and speed",
  height: 190,
  hasSqrtAxes: true,
  x: { size: 20, values: (values) => values.map((value) => String(value)) },
  y: {
    size: 38,
    values: (values) => values.map((value) => String(Number((100 * value).toPrecision(3)))),
  },
};

/** Returns the scatter plot of height and speed of both feet, with boundary and thresholds. */
export function scatterPlot(tracks: Tracks, evidence: Evidence): PlotData {
  const range = evidence.clustering?.field?.max ?? heightSpeedRange(tracks);
  const frames = tracks.left.planted.length;
  const stride = Math.max(1, Math.ceil(frames / maxPoints));
  const positionOf = ({ side, frame }: FootFrame) => ({
    x: Math.min(tracks[side].speed[frame] ?? 0, range.speed),
    y: Math.min(Math.max(tracks[side].height[frame] ?? 0, 0), range.height),
  });
  const contourLines = evidence.clustering?.field && decisionBoundary(evidence);
  return {
    data: [
      [0, range.speed],
      [0, range.height],
    ],
    max: { x: range.speed, y: range.height },
    position: positionOf,
    paint(plot, theme) {
      for (const planted of [0, 1]) {
        for (const side of sides)
          paintPoints(plot, theme, tracks, side, planted, stride, positionOf);
      }
      if (contourLines) paintBoundary(plot, theme, contourLines);
      paintThresholds(plot, theme, evidence);
      paintUnits(plot, theme);
    },
    nearest(plot, left, top) {
      let best: FootFrame | undefined;
      let smallest = maxDistance * maxDistance;
      for (const side of sides) {
        for (let frame = 0; frame < frames; frame += stride) {
          const position = positionOf({ side, frame });
          const x = plot.valToPos(position.x, "x") - left;
          const y = plot.valToPos(position.y, "y") - top;
          if (x * x + y * y < smallest) {
            smallest = x * x + y * y;
            best = { side, frame };
          }
        }
      }
      return best;
    },
    move({ side, frame }, by) {
      if (by === "other-foot") return { side: side === "left" ? "right" : "left", frame };
      const to = { previous: frame - 1, next: frame + 1, first: 0, last: frames - 1 }[by];
      return { side, frame: Math.min(Math.max(to, 0), frames - 1) };
    },
  };
}

/** Draws the planted frames of a foot in the colour of its side, or the other frames in grey. */
function paintPoints(
  plot: uPlot,
  theme: CanvasTheme,
  tracks: Tracks,
  side: "left" | "right",
  planted: number,
  stride: number,
  positionOf: (sample: FootFrame) => { x: number; y: number },
) {
  const { ctx } = plot;
  const radius = (planted ? 2.1 : 1.5) * devicePixelRatio;
  ctx.fillStyle = planted ? theme[side] : theme.borderStrong;
  ctx.globalAlpha = 0.75;
  ctx.beginPath();
  for (let frame = 0; frame < tracks[side].planted.length; frame += stride) {
    if (tracks[side].planted[frame] !== planted) continue;
    const position = positionOf({ side, frame });
    const x = plot.valToPos(position.x, "x", true);
    const y = plot.valToPos(position.y, "y", true);
    ctx.moveTo(x + radius, y);
    ctx.arc(x, y, radius, 0, 7);
  }
  ctx.fill();
  ctx.globalAlpha = 1;
}

/** Returns the decision boundary as line segments: speed and height of both ends. */
function decisionBoundary({ clustering }: Evidence): Float32Array {
  const field = clustering?.field;
  if (!clustering || !field || !Number.isFinite(clustering.threshold)) return new Float32Array(0);
  const { size, max, values } = field;
  const lines = contour(values, size, clustering.threshold);
  return lines.map((step, i) => (i % 2 ? max.height : max.speed) * (step / (size - 1)) ** 2);
}

/** Draws the decision boundary. */
function paintBoundary(plot: uPlot, theme: CanvasTheme, contourLines: Float32Array) {
  const { ctx } = plot;
  ctx.lineCap = "round";
  ctx.beginPath();
  for (let i = 0; i < contourLines.length; i += 4) {
    const x = (k: number) => plot.valToPos(contourLines[i + k] as number, "x", true);
    const y = (k: number) => plot.valToPos(contourLines[i + k] as number, "y", true);
    ctx.moveTo(x(0), y(1));
    ctx.lineTo(x(2), y(3));
  }
  drawPath(ctx, theme.accent, 2 * devicePixelRatio);
}

/** Draws the thresholds of height and speed. */
function paintThresholds(
  plot: uPlot,
  theme: CanvasTheme,
  { thresholds: { height, speed } }: Evidence,
) {
  const { left, top, width } = plot.bbox;
  const gap = 5 * devicePixelRatio;
  if (height !== undefined) {
    paintLine(plot, "y", height, theme.accent);
    const y = plot.valToPos(height, "y", true) - 2 * gap;
    paintText(plot, theme, `${formatValue(100 * height)} cm`, left + width - gap, y, "right");
  }
  if (speed !== undefined) {
    paintLine(plot, "x", speed, theme.accent);
    const x = plot.valToPos(speed, "x", true) + gap;
    paintText(plot, theme, `${formatValue(speed)} m/s`, x, top + 2 * gap, "left");
  }
}

/** Draws the units of the axes in empty corners of the plot. */
function paintUnits(plot: uPlot, theme: CanvasTheme) {
  const { left, top, width, height } = plot.bbox;
  const gap = 6 * devicePixelRatio;
  paintText(plot, theme, "cm", left + gap, top + 1.5 * gap, "left", theme.muted);
  paintText(plot, theme, "m/s", left + width - gap, top + height - 1.5 * gap, "right", theme.muted);
}
