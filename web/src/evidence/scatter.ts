import type uPlot from "uplot";
import { type FootFrame, heightSpeedRange, sides } from "../model/evidence";
import { formatValue } from "../model/explanation";
import type { Evidence, Tracks } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import { contour } from "./contour";
import { type PlotData, type PlotSpec, paintLine, paintText } from "./plot-data";

/** More points of a foot than this would be a blot, and slow to draw. */
const mostPoints = 2000;

/** A pointer this near to a point means it, in pixels. */
const near = 24;

export const scatterFrame: PlotSpec = {
  name: "Height and speed",
  height: 190,
  square: true,
  x: { size: 20, values: (values) => values.map((value) => String(value)) },
  y: {
    size: 38,
    values: (values) => values.map((value) => String(Number((100 * value).toPrecision(3)))),
  },
};

/** The feet of all frames by height and speed, with what parts those planted from the rest. */
export function scatter(tracks: Tracks, why: Evidence): PlotData {
  const reach = why.clustering?.field?.max ?? heightSpeedRange(tracks);
  const frames = tracks.left.planted.length;
  const stride = Math.max(1, Math.ceil(frames / mostPoints));
  const at = ({ side, frame }: FootFrame) => ({
    x: Math.min(tracks[side].speed[frame] ?? 0, reach.speed),
    y: Math.min(Math.max(tracks[side].height[frame] ?? 0, 0), reach.height),
  });
  const line = why.clustering?.field && boundary(why);
  return {
    data: [
      [0, reach.speed],
      [0, reach.height],
    ],
    top: { x: reach.speed, y: reach.height },
    place: at,
    paint(plot, ink) {
      for (const planted of [0, 1]) {
        for (const side of sides) dots(plot, ink, tracks, side, planted, stride, at);
      }
      if (line) paintBoundary(plot, ink, line);
      paintLimits(plot, ink, why);
      paintUnits(plot, ink);
    },
    nearest(plot, left, top) {
      let best: FootFrame | undefined;
      let least = near * near;
      for (const side of sides) {
        for (let frame = 0; frame < frames; frame += stride) {
          const place = at({ side, frame });
          const x = plot.valToPos(place.x, "x") - left;
          const y = plot.valToPos(place.y, "y") - top;
          if (x * x + y * y < least) {
            least = x * x + y * y;
            best = { side, frame };
          }
        }
      }
      return best;
    },
    step({ side, frame }, by) {
      if (by === "other") return { side: side === "left" ? "right" : "left", frame };
      const to = { back: frame - 1, on: frame + 1, first: 0, last: frames - 1 }[by];
      return { side, frame: Math.min(Math.max(to, 0), frames - 1) };
    },
  };
}

/** Planted feet in the colour of their side; those in the air as grey dots. */
function dots(
  plot: uPlot,
  ink: CanvasTheme,
  tracks: Tracks,
  side: "left" | "right",
  planted: number,
  stride: number,
  at: (sample: FootFrame) => { x: number; y: number },
) {
  const { ctx } = plot;
  const radius = (planted ? 2.1 : 1.5) * devicePixelRatio;
  ctx.fillStyle = planted ? ink[side] : ink.edge;
  ctx.globalAlpha = 0.75;
  ctx.beginPath();
  for (let frame = 0; frame < tracks[side].planted.length; frame += stride) {
    if (tracks[side].planted[frame] !== planted) continue;
    const place = at({ side, frame });
    const x = plot.valToPos(place.x, "x", true);
    const y = plot.valToPos(place.y, "y", true);
    ctx.moveTo(x + radius, y);
    ctx.arc(x, y, radius, 0, 7);
  }
  ctx.fill();
  ctx.globalAlpha = 1;
}

/** Where u crosses the threshold: speed and height of both ends of each piece. */
function boundary({ clustering }: Evidence): Float32Array {
  const field = clustering?.field;
  if (!clustering || !field || !Number.isFinite(clustering.threshold)) return new Float32Array(0);
  const { size, max, values } = field;
  const lines = contour(values, size, clustering.threshold);
  return lines.map((at, i) => (i % 2 ? max.height : max.speed) * (at / (size - 1)) ** 2);
}

function paintBoundary(plot: uPlot, ink: CanvasTheme, line: Float32Array) {
  const { ctx } = plot;
  ctx.strokeStyle = ink.accent;
  ctx.lineWidth = 2 * devicePixelRatio;
  ctx.lineCap = "round";
  ctx.beginPath();
  for (let i = 0; i < line.length; i += 4) {
    const x = (k: number) => plot.valToPos(line[i + k] as number, "x", true);
    const y = (k: number) => plot.valToPos(line[i + k] as number, "y", true);
    ctx.moveTo(x(0), y(1));
    ctx.lineTo(x(2), y(3));
  }
  ctx.stroke();
}

function paintLimits(plot: uPlot, ink: CanvasTheme, { thresholds: { height, speed } }: Evidence) {
  const { left, top, width } = plot.bbox;
  const gap = 5 * devicePixelRatio;
  if (height !== undefined) {
    paintLine(plot, "y", height, ink.accent);
    const y = plot.valToPos(height, "y", true) - 2 * gap;
    paintText(plot, ink, `${formatValue(100 * height)} cm`, left + width - gap, y, "right");
  }
  if (speed !== undefined) {
    paintLine(plot, "x", speed, ink.accent);
    const x = plot.valToPos(speed, "x", true) + gap;
    paintText(plot, ink, `${formatValue(speed)} m/s`, x, top + 2 * gap, "left");
  }
}

/** What the axes count, inside the plot where nothing else is. */
function paintUnits(plot: uPlot, ink: CanvasTheme) {
  const { left, top, width, height } = plot.bbox;
  const gap = 6 * devicePixelRatio;
  paintText(plot, ink, "cm", left + gap, top + 1.5 * gap, "left", ink.muted);
  paintText(plot, ink, "m/s", left + width - gap, top + height - 1.5 * gap, "right", ink.muted);
}
