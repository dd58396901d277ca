import { effect, type ReadonlySignal } from "@preact/signals";
import uPlot from "uplot";
import { pause, seek } from "../actions/playback";
import type { FootFrame } from "../model/evidence";
import { pointAt, pointedFrame } from "../store/evidence";
import { frame as playheadFrame } from "../store/playback";
import { theme } from "../store/theme";
import { type CanvasTheme, readCanvasTheme } from "../ui/canvas-theme";
import { createDragLine, type DragLine } from "./drag-line";
import { createMarks, type Marks } from "./marks";
import type { PlotData, PlotSpec, Step } from "./plot-data";
import { squareTicks } from "./sqrt-ticks";

const font = '11px "Inter Variable", system-ui, sans-serif';

/** A picture on uPlot's axes, kept at what the signal holds; returns how to end it. */
export function createPlot(
  host: HTMLElement,
  frame: PlotSpec,
  picture: ReadonlySignal<PlotData>,
): () => void {
  let canvasTheme: CanvasTheme | undefined;
  const themeOf = (plot: uPlot) => {
    canvasTheme ??= readCanvasTheme(host, plot.ctx, devicePixelRatio);
    return canvasTheme;
  };
  const width = () => Math.max(120, host.clientWidth);
  let marks: Marks | undefined;
  let level: DragLine | undefined;
  const plot = new uPlot(
    {
      ...options(frame, picture, themeOf, () => {
        level?.show(picture.peek());
        marks?.draw();
      }),
      width: width(),
      height: frame.height,
    },
    picture.peek().data,
    host,
  );
  marks = createMarks(plot, frame, () => themeOf(plot));
  level = createDragLine(plot, host);
  const stops = [
    effect(() => {
      void theme.value;
      canvasTheme = undefined;
      plot.setData(picture.value.data);
    }),
    effect(() => {
      void theme.value;
      marks?.show(picture.value, playheadFrame.value, pointedFrame.value);
    }),
    listen(host, plot, picture),
  ];
  const observer = new ResizeObserver(() => {
    if (width() === plot.width) return;
    plot.setSize({ width: width(), height: frame.height });
  });
  observer.observe(host);
  return () => {
    observer.disconnect();
    for (const stop of stops) stop();
    marks?.end();
    plot.destroy();
  };
}

function options(
  frame: PlotSpec,
  picture: ReadonlySignal<PlotData>,
  themeOf: (plot: uPlot) => CanvasTheme,
  onDrawn: () => void,
): Omit<uPlot.Options, "width" | "height"> {
  const scale = (key: "x" | "y"): uPlot.Scale => ({
    time: false,
    range: () => [0, picture.peek().top[key]],
    ...(frame.square && { distr: 100, fwd: Math.sqrt, bwd: (value: number) => value * value }),
  });
  const axis = (key: "x" | "y"): uPlot.Axis => ({
    show: !frame[key].hidden,
    size: frame[key].size,
    gap: 4,
    font,
    stroke: (plot) => themeOf(plot).muted,
    grid: { stroke: (plot) => themeOf(plot).border, width: 1 },
    ticks: { show: false },
    space: key === "x" ? 60 : 28,
    filter: (_, splits) => splits,
    values: (_, values) => frame[key].values(values),
    ...(frame.square && { splits: () => squareTicks(picture.peek().top[key]) }),
  });
  return {
    padding: [8, 8, frame.x.hidden ? 4 : 0, 0],
    legend: { show: false },
    cursor: { show: false },
    scales: { x: scale("x"), y: scale("y") },
    axes: [axis("x"), axis("y")],
    series: [
      {},
      {
        stroke: (plot) => themeOf(plot).text,
        width: 1.5,
        points: { show: false },
        ...(frame.square && { paths: () => null }),
      },
    ],
    // Only now the scales are those of the picture.
    hooks: { draw: [(plot) => picture.peek().paint(plot, themeOf(plot)), onDrawn] },
  };
}

const steps: Record<string, Step> = {
  ArrowLeft: "back",
  ArrowRight: "on",
  ArrowUp: "other",
  ArrowDown: "other",
  Home: "first",
  End: "last",
};

/** Pointers and keys: what is pointed at lights up everywhere, a click or Enter goes there. */
function listen(host: HTMLElement, plot: uPlot, picture: ReadonlySignal<PlotData>): () => void {
  const under = (event: MouseEvent): FootFrame | undefined => {
    const box = plot.over.getBoundingClientRect();
    const [left, top] = [event.clientX - box.left, event.clientY - box.top];
    return picture.peek().nearest(plot, left, top);
  };
  const go = (sample: { frame: number } | undefined) => {
    if (!sample) return;
    pause();
    seek(sample.frame);
  };
  const off = new AbortController();
  const quiet = { signal: off.signal };
  const { over } = plot;
  over.addEventListener("pointermove", (event) => pointAt(under(event)), quiet);
  over.addEventListener("pointerleave", () => pointAt(undefined), quiet);
  // A click's place is rounded: it means what was lit.
  over.addEventListener("click", (event) => go(pointedFrame.peek() ?? under(event)), quiet);
  host.addEventListener("blur", () => pointAt(undefined), quiet);
  host.addEventListener(
    "keydown",
    (event) => {
      const by = steps[event.key];
      if (event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return;
      const { frame, side = "left" } = pointedFrame.peek() ?? { frame: playheadFrame.peek() };
      if (by) pointAt(picture.peek().step({ side, frame }, by));
      else if (event.key === "Enter") go(pointedFrame.peek() ?? undefined);
      else if (event.key === "Escape") pointAt(undefined);
      else return;
      event.preventDefault();
    },
    quiet,
  );
  return () => off.abort();
}
