import { effect, type ReadonlySignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { toX } from "../model/time-view";
import { timeView } from "../store/playback";
import type { Layout } from "./layout";
import { margin } from "./scene";

/** Where lines stand: what the timeline lays out, and how wide it is in pixels. */
export interface MarkerArea {
  layout: ReadonlySignal<Layout>;
  width: ReadonlySignal<number>;
}

/**
 * An element that stands at a frame, over all lanes, and is hidden while that is out of sight:
 * one of its own, so that moving it repaints no lane.
 */
export function useMarker(
  { layout, width }: MarkerArea,
  frame: () => number | undefined,
): RefObject<HTMLDivElement | null> {
  const mark = useRef<HTMLDivElement>(null);
  useEffect(
    () =>
      effect(() => {
        const { labels, minimap } = layout.value;
        const inner = width.value - labels - margin;
        const at = frame();
        const x = at === undefined ? -9 : toX(timeView.value, at, inner);
        if (!mark.current) return;
        const { style, dataset } = mark.current;
        style.visibility = x < -1 || x > inner + 1 ? "hidden" : "visible";
        style.transform = `translateX(${labels + x}px)`;
        style.height = `${minimap.y - 4}px`;
        dataset.frame = at === undefined ? "" : String(at);
      }),
    [layout, width],
  );
  return mark;
}
