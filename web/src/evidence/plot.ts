import { effect, type ReadonlySignal } from "@preact/signals";
import uPlot from "uplot";
import { pause, seek } from "../actions/view/playback";
import type { FootFrame } from "../model/plants/evidence";
import { pointAt, pointedFrame } from "../store/evidence";
import { frame as playheadFrame } from "../store/playback";
import { theme } from "../store/theme";
import { type CanvasTheme, readCanvasTheme } from "../ui/canvas-theme";
import { createDragLine, type DragLine } from "./drag-line";
import { createMarkers, type Markers } from "./markers";
import type { Move, PlotData, PlotSpec } from "./plot-data";
import { sqrtTicks } from "./sqrt-ticks";

const font = '11px "Inter Variable", system-ui, sans-serif';

/** Creates a plot and updates it from the signal. Returns a function that removes it. */
export function createPlot(
  host: HTMLElement,
  spec: PlotSpec,
  plotData: ReadonlySignal<PlotData>,
): () => void {
  let canvasTheme: CanvasTheme | undefined;
  const themeOf = (plot: uPlot) => {
    canvasTheme ??= readCanvasTheme(host, plot.ctx, devicePixelRatio);
    return canvasTheme;
  };
  const width = () => Math.max(120, host.clientWidth);
  let markers: Markers | undefined;
  let dragLine: DragLine | undefined;
  const plot = new uPlot(
    {
      ...options(spec, plotData, themeOf, () => {
        dragLine?.update(plotData.peek());
        markers?.redraw();
      }),
      width: width(),
      height: spec.height,
    },
    plotData.peek().data,
    host,
  );
  markers = createMarkers(plot, spec, () => themeOf(plot));
  dragLine = createDragLine(plot, host);
  const disposers = [
    effect(() => {
      void theme.value;
      canvasTheme = undefined;
      plot.setData(plotData.value.data);
    }),
    effect(() => {
      void theme.value;
      markers?.update(plotData.value, playheadFrame.value, pointedFrame.value);
    }),
    attachListeners(host, plot, plotData),
  ];
  const observer = new ResizeObserver(() => {
    if (width() === plot.width) return;
    plot.setSize({ width: width(), height: spec.height });
  });
  observer.observe(host);
  return () => {
    observer.disconnect();
    for (const dispose of disposers) dispose();
    markers?.dispose();
    plot.destroy();
  };
}

/** Returns the uPlot options of a plot. */
function options(
  spec: PlotSpec,
  plotData: ReadonlySignal<PlotData>,
  themeOf: (plot: uPlot) => CanvasTheme,
  onDrawn: () => void,
): Omit<uPlot.Options, "width" | "height"> {
  const scale = (key: "x" | "y"): uPlot.Scale => ({
    time: false,
    range: () => [0, plotData.peek().max[key]],
    ...(spec.hasSqrtAxes && { distr: 100, fwd: Math.sqrt, bwd: (value: number) => value * value }),
  });
  const axis = (key: "x" | "y"): uPlot.Axis => ({
    show: !spec[key].hidden,
    size: spec[key].size,
    gap: 4,
    font,
    stroke: (plot) => themeOf(plot).muted,
    grid: { stroke: (plot) => themeOf(plot).border, width: 1 },
    ticks: { show: false },
    space: key === "x" ? 60 : 28,
    filter: (_, splits) => splits,
    values: (_, values) => spec[key].values(values),
    ...(spec.hasSqrtAxes && { splits: () => sqrtTicks(plotData.peek().max[key]) }),
  });
  return {
    padding: [8, 8, spec.x.hidden ? 4 : 0, 0],
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
        ...(spec.hasSqrtAxes && { paths: () => null }),
      },
    ],
    // The scales are up to date only in the draw hook.
    hooks: { draw: [(plot) => plotData.peek().paint(plot, themeOf(plot)), onDrawn] },
  };
}

const movesByKey: Record<string, Move> = {
  ArrowLeft: "previous",
  ArrowRight: "next",
  ArrowUp: "other-foot",
  ArrowDown: "other-foot",
  Home: "first",
  End: "last",
};

/** Handles pointer and keys: they select the pointed frame; a click or Enter seeks to it. */
function attachListeners(
  host: HTMLElement,
  plot: uPlot,
  plotData: ReadonlySignal<PlotData>,
): () => void {
  const sampleAt = (event: MouseEvent): FootFrame | undefined => {
    const box = plot.over.getBoundingClientRect();
    const [left, top] = [event.clientX - box.left, event.clientY - box.top];
    return plotData.peek().nearest(plot, left, top);
  };
  const seekTo = (sample: { frame: number } | undefined) => {
    if (!sample) return;
    pause();
    seek(sample.frame);
  };
  const listeners = new AbortController();
  const listenerOptions = { signal: listeners.signal };
  const { over } = plot;
  over.addEventListener("pointermove", (event) => pointAt(sampleAt(event)), listenerOptions);
  over.addEventListener("pointerleave", () => pointAt(undefined), listenerOptions);
  // Click positions are rounded, so the frame that was highlighted is used.
  over.addEventListener(
    "click",
    (event) => seekTo(pointedFrame.peek() ?? sampleAt(event)),
    listenerOptions,
  );
  host.addEventListener("blur", () => pointAt(undefined), listenerOptions);
  host.addEventListener(
    "keydown",
    (event) => {
      const move = movesByKey[event.key];
      if (event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return;
      const from = pointedFrame.peek() ?? { frame: playheadFrame.peek() };
      const sample = { side: from.side ?? ("left" as const), frame: from.frame };
      if (move) pointAt(plotData.peek().move(sample, move));
      else if (event.key === "Enter") seekTo(pointedFrame.peek() ?? undefined);
      else if (event.key === "Escape") pointAt(undefined);
      else return;
      event.preventDefault();
    },
    listenerOptions,
  );
  return () => listeners.abort();
}
