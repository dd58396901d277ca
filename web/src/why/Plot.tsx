import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { clip, frame as playheadFrame } from "../app/state";
import { pointed } from "../app/why";
import type { Frame, Picture } from "./picture";
import { draw } from "./plot";

/** A plot that is walked through by frames, with a pointer or with keys; `text` says what it shows. */
export function Plot({
  frame,
  picture,
  text,
}: {
  frame: Frame;
  picture: ReadonlySignal<Picture>;
  text: ReadonlySignal<string>;
}) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(
    () => (host.current ? draw(host.current, frame, picture) : undefined),
    [frame, picture],
  );
  const at = useComputed(() => pointed.value?.frame ?? playheadFrame.value);
  return (
    <div
      ref={host}
      class="why-plot"
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
