import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { pointedFrame } from "../store/evidence";
import { frame as playheadFrame } from "../store/playback";
import { clip } from "../store/session";
import { createPlot } from "./plot";
import type { PlotData, PlotSpec } from "./plot-data";

/** A plot that is walked through by frames, with a pointer or with keys; `text` says what it shows. */
export function Plot({
  frame,
  picture,
  text,
}: {
  frame: PlotSpec;
  picture: ReadonlySignal<PlotData>;
  text: ReadonlySignal<string>;
}) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(
    () => (host.current ? createPlot(host.current, frame, picture) : undefined),
    [frame, picture],
  );
  const at = useComputed(() => pointedFrame.value?.frame ?? playheadFrame.value);
  return (
    <div
      ref={host}
      class="plot"
      data-height={frame.height}
      role="slider"
      tabIndex={0}
      aria-label={frame.name}
      aria-valuemin={0}
      aria-valuemax={Math.max(0, (clip.value?.frames ?? 1) - 1)}
      aria-valuenow={at}
      aria-valuetext={text}
    />
  );
}
