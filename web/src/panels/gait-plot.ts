import { effect, type ReadonlySignal } from "@preact/signals";
import uPlot from "uplot";
import { valueAtPercent } from "../model/motion/gait-cycle";
import type { AngleCurve, Side } from "../model/types";
import { theme } from "../store/theme";
import { type CanvasTheme, readCanvasTheme } from "../ui/canvas-theme";
import { drawPath } from "../util/draw-path";
import { formatNumber } from "../util/format";

/** Position in the gait cycle of each foot, in percent; undefined outside of strides. */
export type Percents = Record<Side, number | undefined>;

const height = 116;
const font = '11px "Inter Variable", system-ui, sans-serif';
const sides = ["left", "right"] as const;
const percents = Array.from({ length: 101 }, (_, percent) => percent);

/** Plots one joint's curves with their deviations and markers at positions in the gait cycle. Returns a function that removes the plot. */
export function createGaitPlot(
  host: HTMLElement,
  curve: AngleCurve,
  position: ReadonlySignal<Percents>,
): () => void {
  let canvasTheme: CanvasTheme | undefined;
  const themeOf = (plot: uPlot) => {
    canvasTheme ??= readCanvasTheme(host, plot.ctx, devicePixelRatio);
    return canvasTheme;
  };
  const width = () => Math.max(120, host.clientWidth);
  const plot = new uPlot(
    {
      width: width(),
      height,
      padding: [8, 14, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false, range: [0, 100] }, y: { range: rangeOf(curve) } },
      axes: [axis(themeOf, 20, (value) => `${value}`), axis(themeOf, 34, degrees)],
      series: [{}, ...sides.flatMap((side) => seriesOf(side, themeOf))],
      bands: sides.map((side, i) => ({
        series: [3 + 3 * i, 2 + 3 * i],
        fill: (self) => themeOf(self).tint[side],
      })),
      hooks: { draw: [(self) => drawMarkers(self, themeOf(self), curve, position.peek())] },
    },
    [percents, ...sides.flatMap((side) => valuesOf(curve, side))],
    host,
  );
  const disposers = [
    effect(() => {
      void theme.value;
      canvasTheme = undefined;
      void position.value;
      plot.redraw(false);
    }),
  ];
  const observer = new ResizeObserver(() => {
    if (width() !== plot.width) plot.setSize({ width: width(), height });
  });
  observer.observe(host);
  return () => {
    observer.disconnect();
    for (const dispose of disposers) dispose();
    plot.destroy();
  };
}

const degrees = (value: number) => `${formatNumber(value, 0)}°`;

/** Returns mean, mean − sd and mean + sd of one side. */
function valuesOf(curve: AngleCurve, side: Side): (number | null)[][] {
  const { mean, sd } = curve[side] ?? {};
  const shifted = (sign: number) =>
    percents.map((percent) => {
      const value = mean?.[percent];
      return value === undefined ? null : value + sign * (sd?.[percent] ?? 0);
    });
  return [shifted(0), shifted(-1), shifted(1)];
}

/** Returns the range of the axis of angles: that of the curves, in tens of degrees. */
function rangeOf(curve: AngleCurve): [number, number] {
  const values = sides
    .flatMap((side) => valuesOf(curve, side).flat())
    .filter((value) => value !== null);
  const low = Math.min(0, ...values);
  const high = Math.max(10, ...values);
  return [Math.floor(low / 10) * 10, Math.ceil(high / 10) * 10];
}

function axis(
  themeOf: (plot: uPlot) => CanvasTheme,
  size: number,
  text: (value: number) => string,
): uPlot.Axis {
  return {
    size,
    gap: 4,
    font,
    stroke: (plot) => themeOf(plot).muted,
    grid: { stroke: (plot) => themeOf(plot).border, width: 1 },
    ticks: { show: false },
    space: size === 20 ? 44 : 26,
    values: (_, values) => values.map(text),
  };
}

function seriesOf(side: Side, themeOf: (plot: uPlot) => CanvasTheme): uPlot.Series[] {
  const invisible: uPlot.Series = { stroke: "transparent", width: 0, points: { show: false } };
  const mean: uPlot.Series = {
    stroke: (plot) => themeOf(plot)[side],
    width: 1.75,
    points: { show: false },
    ...(side === "right" && { dash: [6, 3] }),
  };
  return [mean, invisible, invisible];
}

function drawMarkers(plot: uPlot, colors: CanvasTheme, curve: AngleCurve, position: Percents) {
  const { ctx, bbox } = plot;
  for (const side of sides) {
    const percent = position[side];
    const value = percent === undefined ? undefined : valueAtPercent(curve[side]?.mean, percent);
    if (percent === undefined || value === undefined) continue;
    const x = plot.valToPos(percent, "x", true);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    drawPath(ctx, colors[side], devicePixelRatio);
    ctx.beginPath();
    ctx.arc(x, plot.valToPos(value, "y", true), 3.5 * devicePixelRatio, 0, 2 * Math.PI);
    ctx.fillStyle = colors[side];
    ctx.fill();
  }
}
