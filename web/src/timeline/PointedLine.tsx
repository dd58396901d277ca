import { effect, type ReadonlySignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { timeView } from "../app/state";
import { pointed } from "../app/why";
import { toX } from "../lib/timeView";
import type { Layout } from "./layout";
import { margin } from "./scene";

/** The frame whose point a pointer or a key rests on, with its number. */
export function PointedLine({
  layout,
  width,
}: {
  layout: ReadonlySignal<Layout>;
  width: ReadonlySignal<number>;
}) {
  const mark = useRef<HTMLDivElement>(null);
  useEffect(
    () =>
      effect(() => {
        const { labels, minimap } = layout.value;
        const inner = width.value - labels - margin;
        const at = pointed.value?.frame;
        const x = at === undefined ? -9 : toX(timeView.value, at, inner);
        if (!mark.current) return;
        const { style } = mark.current;
        style.visibility = x < -1 || x > inner + 1 ? "hidden" : "visible";
        style.transform = `translateX(${labels + x}px)`;
        style.height = `${minimap.y - 4}px`;
        mark.current.dataset.frame = at === undefined ? "" : String(at);
      }),
    [layout, width],
  );
  return <div class="pointed-line" ref={mark} aria-hidden="true" />;
}
