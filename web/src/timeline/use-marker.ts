import { effect, type ReadonlySignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { toX } from "../model/time-view";
import { timeView } from "../store/playback";
import type { Layout } from "./layout";
import { margin } from "./scene";

/** The area in which a marker moves. */
export interface MarkerArea {
  layout: ReadonlySignal<Layout>;
  /** Width of the timeline, in pixels. */
  width: ReadonlySignal<number>;
}

/**
 * Places an element over all lanes at a frame, and hides it outside the visible range. Moving it does
 * not redraw the canvas.
 */
export function useMarker(
  { layout, width }: MarkerArea,
  frame: () => number | undefined,
): RefObject<HTMLDivElement | null> {
  const element = useRef<HTMLDivElement>(null);
  useEffect(
    () =>
      effect(() => {
        const { labelWidth, minimap } = layout.value;
        const laneWidth = width.value - labelWidth - margin;
        const current = frame();
        const x = current === undefined ? -9 : toX(timeView.value, current, laneWidth);
        if (!element.current) return;
        const { style, dataset } = element.current;
        style.visibility = x < -1 || x > laneWidth + 1 ? "hidden" : "visible";
        style.transform = `translateX(${labelWidth + x}px)`;
        style.height = `${minimap.y - 4}px`;
        dataset.frame = current === undefined ? "" : String(current);
      }),
    [layout, width],
  );
  return element;
}
