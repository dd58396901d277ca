import { useRef } from "preact/hooks";
import type { Preference } from "../store/preferences";

/** Change of the size by a key, in pixels. */
const keyStep = 24;

interface Props {
  /** Name of what is resized. */
  label: string;
  /** Orientation of the line: a horizontal one resizes what is below it, a vertical one what is right of it. */
  orientation: "horizontal" | "vertical";
  /** Size in pixels; null for the default. The style sheet limits it. */
  size: Preference<number | null>;
  /** Returns the current size, in pixels. */
  measure: () => number;
}

/** A line that resizes the part after it by drag and by keys; a double click restores the default. */
export function Splitter({ label, orientation, size, measure }: Props) {
  const isHorizontal = orientation === "horizontal";
  const positionOf = (event: PointerEvent) => (isHorizontal ? event.clientY : event.clientX);
  /** Where the drag began; `size` is that of the resized part. */
  const start = useRef<{ position: number; size: number }>(null);
  return (
    <hr
      class="splitter"
      aria-label={label}
      aria-orientation={orientation}
      aria-valuenow={size.value ?? measure()}
      title={`${label}: drag, or double-click for the default`}
      tabIndex={0}
      onPointerDown={(event) => {
        event.preventDefault();
        event.currentTarget.setPointerCapture(event.pointerId);
        start.current = { position: positionOf(event), size: measure() };
      }}
      onPointerMove={(event) => {
        const from = start.current;
        if (!from || !event.currentTarget.hasPointerCapture(event.pointerId)) return;
        size.set(Math.max(1, from.size + from.position - positionOf(event)));
      }}
      onLostPointerCapture={() => {
        // The style sheet may have limited it.
        if (start.current && size.value !== null) size.set(measure());
        start.current = null;
      }}
      onDblClick={() => size.set(null)}
      onKeyDown={(event) => {
        const [larger, smaller] = isHorizontal
          ? ["ArrowUp", "ArrowDown"]
          : ["ArrowLeft", "ArrowRight"];
        const by = { [larger]: keyStep, [smaller]: -keyStep }[event.key];
        if (by === undefined) return;
        event.preventDefault();
        size.set(Math.max(1, measure() + by));
      }}
    />
  );
}

/** Sets a custom property of an element to a length, or removes it. */
export function setSize(element: HTMLElement | null, property: string, pixels: number | null) {
  if (pixels === null) element?.style.removeProperty(property);
  else element?.style.setProperty(property, `${pixels}px`);
}
