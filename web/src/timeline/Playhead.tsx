import { useComputed } from "@preact/signals";
import { pause, seek, segmentAtPlayhead } from "../actions/playback";
import { plantAt } from "../model/plants";
import { segmentTitle } from "../model/segments";
import { toFrame } from "../model/time-view";
import { frame, playhead, timeView } from "../store/playback";
import { clip, detection, plants } from "../store/session";
import { margin } from "./scene";
import { type MarkerArea, useMarker } from "./use-marker";

/** The line over everything, and what is to be heard of its moment. */
export function Playhead(room: MarkerArea) {
  const { layout, width } = room;
  const mark = useMarker(room, () => playhead.value);
  const text = useComputed(() => {
    const at = frame.value;
    const rate = clip.value?.rate ?? 1;
    const foot = (side: "left" | "right") =>
      plantAt(plants.value, at, side) ? `${side} planted` : `${side} in the air`;
    const feet = detection.value ? `, ${foot("left")}, ${foot("right")}` : "";
    const action = segmentAtPlayhead();
    const segment = action
      ? `, ${[`segment ${action.number}`, segmentTitle(action)].join(" ").trim()}`
      : "";
    return `${(at / rate).toFixed(3)} s, frame ${at}${feet}${segment}`;
  });
  const drag = (event: PointerEvent) => {
    const handle = event.currentTarget as HTMLElement;
    if (event.type === "pointerdown") {
      handle.setPointerCapture(event.pointerId);
      pause();
    }
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const area = handle.closest(".tracks")?.getBoundingClientRect();
    if (!area) return;
    const { labels } = layout.peek();
    const view = timeView.peek();
    const at = toFrame(view, event.clientX - area.left - labels, width.peek() - labels - margin);
    seek(Math.min(Math.max(at, view.start), view.end));
  };
  return (
    <div class="playhead" ref={mark}>
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
