import { effect, type ReadonlySignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { toX } from "../model/motion/time-view";
import { timeView } from "../store/playback";
import { clip } from "../store/session";
import type { Layout } from "./layout";
import { margin } from "./scene";

/** The area in which a marker moves. */
export interface MarkerArea {
  layout: ReadonlySignal<Layout>;
  /** Width of the timeline, in pixels. */
  width: ReadonlySignal<number>;
}

/**
 * Places an element at a frame, and hides it outside the visible range: over all lanes, or in the overview
 * of the clip. Moving it does not redraw the canvas.
 */
export function useMarker(
  { layout, width }: MarkerArea,
  frame: () => number | undefined,
  place: "lanes" | "overview" = "lanes",
): RefObject<HTMLDivElement | null> {
  const element = useRef<HTMLDivElement>(null);
  useEffect(
    () =>
      effect(() => {
        const { labelWidth, minimap } = layout.value;
        const laneWidth = width.value - labelWidth - margin;
        const current = frame();
        const isInOverview = place === "overview";
        const view = isInOverview ? { start: 0, end: clip.value?.frames ?? 1 } : timeView.value;
        const x = current === undefined ? -9 : toX(view, current, laneWidth);
        if (!element.current) return;
        const { style, dataset } = element.current;
        style.visibility = x < -1 || x > laneWidth + 1 ? "hidden" : "visible";
        const [top, height] = isInOverview ? [minimap.y, minimap.height] : [0, minimap.y - 4];
        style.transform = `translate(${labelWidth + x}px, ${top}px)`;
        style.height = `${height}px`;
        dataset.frame = current === undefined ? "" : String(current);
      }),
    [layout, width, place],
  );
  return element;
}
