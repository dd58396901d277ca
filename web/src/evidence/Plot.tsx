import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { pointedFrame } from "../store/evidence";
import { frame as playheadFrame } from "../store/playback";
import { clip } from "../store/session";
import { createPlot } from "./plot";
import type { PlotData, PlotSpec } from "./plot-data";

/** A plot in which frames are selected with the pointer or with keys; `text` describes the frame. */
export function Plot({
  spec,
  plotData,
  text,
}: {
  spec: PlotSpec;
  plotData: ReadonlySignal<PlotData>;
  text: ReadonlySignal<string>;
}) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(
    () => (host.current ? createPlot(host.current, spec, plotData) : undefined),
    [spec, plotData],
  );
  const currentFrame = useComputed(() => pointedFrame.value?.frame ?? playheadFrame.value);
  return (
    <div
      ref={host}
      class="plot"
      data-height={spec.height}
      role="slider"
      tabIndex={0}
      aria-label={spec.name}
      aria-valuemin={0}
      aria-valuemax={Math.max(0, (clip.value?.frames ?? 1) - 1)}
      aria-valuenow={currentFrame}
      aria-valuetext={text}
    />
  );
}
