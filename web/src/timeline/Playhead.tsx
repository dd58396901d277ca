import { useComputed } from "@preact/signals";
import { pause, seek, segmentAtPlayhead } from "../actions/view/playback";
import { toFrame } from "../model/motion/time-view";
import { plantAt } from "../model/plants/plants";
import { segmentTitle } from "../model/segments/segments";
import { frame, playhead, timeView } from "../store/playback";
import { clip, detection, plants } from "../store/session";
import { margin } from "./scene";
import { type MarkerArea, useMarker } from "./use-marker";

/** The playhead: a line with a handle, and the state of the frame for screen readers. */
export function Playhead(area: MarkerArea) {
  const { layout, width } = area;
  const element = useMarker(area, () => playhead.value);
  const text = useComputed(() => {
    const current = frame.value;
    const rate = clip.value?.rate ?? 1;
    const foot = (side: "left" | "right") =>
      plantAt(plants.value, current, side) ? `${side} in contact` : `${side} in the air`;
    const feet = detection.value ? `, ${foot("left")}, ${foot("right")}` : "";
    const segment = segmentAtPlayhead();
    const segmentText = segment
      ? `, ${[`segment ${segment.number}`, segmentTitle(segment)].join(" ").trim()}`
      : "";
    return `${(current / rate).toFixed(3)} s, frame ${current}${feet}${segmentText}`;
  });
  const drag = (event: PointerEvent) => {
    const handle = event.currentTarget as HTMLElement;
    if (event.type === "pointerdown") {
      handle.setPointerCapture(event.pointerId);
      pause();
    }
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const bounds = handle.closest(".tracks")?.getBoundingClientRect();
    if (!bounds) return;
    const { labelWidth } = layout.peek();
    const view = timeView.peek();
    const current = toFrame(
      view,
      event.clientX - bounds.left - labelWidth,
      width.peek() - labelWidth - margin,
    );
    seek(Math.min(Math.max(current, view.start), view.end));
  };
  return (
    <div class="playhead" ref={element}>
      <div
        class="playhead-handle"
        role="slider"
        tabIndex={0}
        aria-label="Playhead"
        aria-valuemin={0}
        aria-valuemax={Math.max(0, (clip.value?.frames ?? 1) - 1)}
        aria-valuenow={frame}
        aria-valuetext={text}
        onPointerDown={drag}
        onPointerMove={drag}
      />
    </div>
  );
}

/** The playhead in the overview of the clip. */
export function MinimapPlayhead(area: MarkerArea) {
  const element = useMarker(area, () => playhead.value, "overview");
  return <div class="minimap-playhead" ref={element} aria-hidden="true" />;
}
