/** Playback: the playhead, the visible part of the timeline, speed and loop. */

import { computed, signal } from "@preact/signals";
import { sessionField } from "./clip-session";
import { namedSegments } from "./session";

export type { Loop } from "./clip-session";

/** Current moment, in frames; fractional while playing. */
export const playhead = sessionField((open) => open.playhead);

/** The part of the clip that the timeline shows. */
export const timeView = sessionField((open) => open.timeView);

/** Range that playback repeats. */
export const loop = sessionField((open) => open.loop);

/** Frames of the looped plant, segment or range, half-open. */
export const loopRegion = sessionField((open) => open.loopRegion);

export const playing = signal(false);

/** Direction of playback: −1 is backwards. */
export const direction = signal<1 | -1>(1);

/** Playback rate; 1 is real time. */
export const speed = signal(1);

/** Whole frame under the playhead. */
export const frame = computed(() => Math.floor(playhead.value + 1e-6));

/** Frames of the looped plant, segment or range; null if the loop is off or covers the clip. */
export const loopedRange = computed(() =>
  loop.value === "off" || loop.value === "clip" ? null : loopRegion.value,
);

/** The looped segment, if a segment is looped. */
export const loopedSegment = computed(() => {
  const start = loop.value === "segment" ? loopRegion.value?.start : undefined;
  return namedSegments.value.find((segment) => segment.start === start);
});
