import { useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { moveVideo, setVideoOffset } from "../actions/view/video";
import { toX } from "../model/motion/time-view";
import { timeView } from "../store/playback";
import { openClip } from "../store/session";
import { video, videoDuration } from "../store/video";
import { formatNumber } from "../util/format";
import { margin } from "./scene";
import type { MarkerArea } from "./use-marker";

/** Change of the offset by a key, in frames: without and with Shift. */
const keySteps = [1, 10] as const;

/** The video on the time axis; dragging its bar moves it relative to the clip. */
export function VideoLane({ layout, width }: MarkerArea) {
  const lane = useRef<HTMLDivElement>(null);
  const bar = useRef<HTMLDivElement>(null);
  const start = useRef<{ x: number; offset: number }>(null);
  const laneWidth = () => Math.max(1, width.value - layout.value.labelWidth - margin);
  useSignalEffect(() => {
    const shown = video.value;
    if (!lane.current || !bar.current || !shown) return;
    const rate = openClip.value?.rate ?? 1;
    const { labelWidth } = layout.value;
    lane.current.style.marginLeft = `${labelWidth}px`;
    lane.current.style.width = `${laneWidth()}px`;
    const x = (seconds: number) => toX(timeView.value, seconds * rate, laneWidth());
    const [from, to] = [shown.offset, shown.offset + (videoDuration.value ?? 0) / shown.rate].map(
      x,
    );
    bar.current.style.left = `${from}px`;
    bar.current.style.width = `${Math.max(24, (to ?? 0) - (from ?? 0))}px`;
  });
  const shown = video.value;
  if (!shown?.url || shown.problem) return null;
  const rate = openClip.value?.rate ?? 1;
  const offset = shown.offset;
  return (
    <div class="video-lane">
      <span class="video-label">Video</span>
      <div class="video-track" ref={lane}>
        <div
          ref={bar}
          class="video-bar"
          role="slider"
          tabIndex={0}
          aria-label="Beginning of the video"
          aria-valuemin={-86400}
          aria-valuemax={86400}
          aria-valuenow={Number(offset.toFixed(3))}
          aria-valuetext={`${formatNumber(offset, 3)} s, ${formatNumber(offset * rate, 1)} frames`}
          title="Drag to move the video relative to the clip; arrow keys move it by a frame, with Shift by ten"
          onPointerDown={(event) => {
            event.preventDefault();
            event.currentTarget.focus();
            event.currentTarget.setPointerCapture(event.pointerId);
            start.current = { x: event.clientX, offset };
          }}
          onPointerMove={(event) => {
            const from = start.current;
            if (!from || !event.currentTarget.hasPointerCapture(event.pointerId)) return;
            const { start: first, end } = timeView.peek();
            const frames = ((event.clientX - from.x) / laneWidth()) * (end - first);
            setVideoOffset(from.offset + frames / rate);
          }}
          onLostPointerCapture={() => {
            start.current = null;
          }}
          onKeyDown={(event) => {
            const direction = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
            if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
            event.preventDefault();
            event.stopPropagation();
            moveVideo(direction * keySteps[event.shiftKey ? 1 : 0]);
          }}
        >
          <span>{shown.name}</span>
        </div>
      </div>
    </div>
  );
}
