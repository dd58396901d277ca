/** Playing, stepping, looping, and zooming the timeline. */

import { batch } from "@preact/signals";
import { clampView, scrollToFrame, zoomAt } from "../../model/motion/time-view";
import type { FrameRange } from "../../model/plants/edits";
import { nextEdge, type Plant, plantAt } from "../../model/plants/plants";
import { type NamedSegment, segmentAt, segmentKind } from "../../model/segments/segments";
import {
  direction,
  frame,
  type Loop,
  loop,
  loopedRange,
  loopRegion,
  playhead,
  playing,
  speed,
  timeView,
} from "../../store/playback";
import { clip, cuts, isPreview, namedSegments, plants, selected } from "../../store/session";
import { mediaClock } from "../../store/video";
import { announce } from "../../store/view";
import { spokenRange } from "../../util/format";

export const speeds = [0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 4] as const;

/** Longest time that one animation frame advances, in seconds; background tabs get no frames. */
const maxElapsed = 0.25;

export const prefersReducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

let previousTime = 0;

const lastFrame = () => Math.max(0, (clip.value?.frames ?? 0) - 1);

function tick(now: number) {
  const current = clip.value;
  if (!playing.value || !current || current.frames < 2) {
    playing.value = false;
    return;
  }
  // The time stamp of the first animation frame may lie before the start.
  const elapsed = Math.min(Math.max(0, now - previousTime) / 1000, maxElapsed);
  previousTime = now;
  const region = isPreview.value ? null : loopedRange.value;
  const start = region?.start ?? 0;
  const end = region ? Math.min(region.end, lastFrame()) : lastFrame();
  const sign = isPreview.value ? 1 : direction.value;
  const factor = isPreview.value ? 1 : speed.value;
  const expected = playhead.value + sign * elapsed * current.rate * factor;
  const shown = isPreview.value ? undefined : mediaClock.current?.momentAt(expected);
  let next = shown ?? expected;
  if (sign > 0 ? next >= end : next < start) {
    const length = end - start;
    if (loop.value === "off" && !isPreview.value) {
      playing.value = false;
      next = sign > 0 ? end : start;
    } else if (length > 0) {
      next = start + ((((next - start) % length) + length) % length);
    } else next = start;
  }
  showMoment(next);
  requestAnimationFrame(tick);
}

function showMoment(next: number) {
  playhead.value = next;
  const view = scrollToFrame(timeView.value, next, clip.value?.frames ?? 1);
  if (view !== timeView.value) timeView.value = view;
}

export function play() {
  if (playing.value || lastFrame() < 1) return;
  if (loop.value === "off") {
    if (direction.value > 0 && playhead.value >= lastFrame()) playhead.value = 0;
    if (direction.value < 0 && playhead.value <= 0) playhead.value = lastFrame();
  }
  playing.value = true;
  previousTime = performance.now();
  requestAnimationFrame(tick);
}

/** Pauses at a whole frame. */
export function pause() {
  if (!playing.value) return;
  playing.value = false;
  playhead.value = frame.value;
}

/** Plays forwards, or pauses. */
export function togglePlay() {
  if (playing.value) return pause();
  direction.value = 1;
  play();
}

/** Plays in a direction at normal speed; if it plays in that direction already, faster. */
export function shuttle(to: 1 | -1) {
  if (playing.value && direction.value === to) {
    changeSpeed(1);
    return;
  }
  if (playing.value || direction.value !== to) speed.value = 1;
  direction.value = to;
  play();
}

/** Moves the playhead to a whole frame, and scrolls the timeline to it. */
export function seek(moment: number) {
  showMoment(Math.floor(Math.min(Math.max(moment, 0), lastFrame()) + 1e-6));
}

/** Pauses and moves the playhead. */
export function jumpTo(moment: number) {
  pause();
  seek(moment);
}

export const jumpToEnd = () => jumpTo(lastFrame());

export function stepFrame(by: number) {
  jumpTo(frame.value + by);
}

/** Goes to the next or previous of some frames, or to the end of the clip. Returns that frame, if there is one. */
export function stepThrough(frames: readonly number[], direction: 1 | -1): number | undefined {
  const next = nextEdge(frames, frame.value, direction);
  jumpTo(next ?? (direction > 0 ? lastFrame() : 0));
  return next;
}

export function seekPlant(plant: Plant) {
  batch(() => {
    seek(plant.start);
    if (loop.value === "plant") loopRegion.value = plant;
    announce(`Plant ${plant.number}, ${plant.side} foot, ${spokenRange(plant)}`);
  });
}

/** Goes to the next or previous cut between segments, or to the end of the clip. */
export const stepCut = (direction: 1 | -1) => stepThrough(cuts.value, direction);

/** Goes to the start of a segment and loops it. */
export function loopSegment(segment: NamedSegment) {
  batch(() => {
    loopRegion.value = segment;
    loop.value = "segment";
    seek(segment.start);
    const details = [segment.name, segmentKind(segment)].filter(Boolean).join(", ");
    announce(`Segment ${segment.number}${details && `, ${details}`}, ${spokenRange(segment)}`);
  });
}

/** What is looped. */
export interface LoopState {
  kind: Loop;
  region: FrameRange | null;
}

/** Loops what was looped before. */
export function restoreLoop({ kind, region }: LoopState) {
  batch(() => {
    loopRegion.value = region;
    loop.value = kind;
  });
}

/** Returns the segment under the playhead. */
export const segmentAtPlayhead = () => segmentAt(namedSegments.value, frame.value);

export function changeSpeed(direction: 1 | -1) {
  const nearest = speeds.findIndex((value) => value >= speed.value);
  const next = speeds[Math.min(Math.max(nearest + direction, 0), speeds.length - 1)];
  if (next) speed.value = next;
}

/** Loops a range of frames, half-open. */
export function loopRange(range: FrameRange) {
  batch(() => {
    loopRegion.value = range;
    loop.value = "range";
    announce(`Loop ${spokenRange(range)}`);
  });
}

/** Makes the frame at the playhead the first or the last one of the looped range. */
export function setLoopEdge(edge: "start" | "end") {
  const { start, end } = loopedRange.value ?? { start: 0, end: lastFrame() + 1 };
  const at = frame.value;
  if (edge === "start") loopRange({ start: at, end: at < end ? end : lastFrame() + 1 });
  else loopRange({ start: at >= start ? start : 0, end: at + 1 });
}

/** Returns the selected plant, or else that under the playhead or the next one. */
function plantToLoop(): Plant | undefined {
  const [all, ref, now] = [plants.value, selected.value, playhead.value];
  const isSelected = ({ side, start }: Plant) => side === ref?.side && start === ref.start;
  return all.find(isSelected) ?? plantAt(all, now) ?? all.find(({ start }) => start >= now);
}

/** Loops nothing, the clip, the selected plant or the one at the playhead, or the segment there. */
export function cycleLoop() {
  const plant = plantToLoop();
  const regions = { plant, segment: segmentAtPlayhead() };
  const order = ["off", "clip", "plant", "segment"] as const;
  const next = order
    .slice(loop.value === "range" ? order.length : order.indexOf(loop.value) + 1)
    .find((kind) => kind === "clip" || (kind !== "off" && regions[kind]));
  batch(() => {
    loopRegion.value = ((next === "plant" || next === "segment") && regions[next]) || null;
    loop.value = next ?? "off";
  });
}

export function fitTimeline() {
  const frames = clip.value?.frames ?? 1;
  timeView.value = clampView({ start: 0, end: frames }, frames);
}

/** Zooms around the playhead, or around the middle if the playhead is out of sight. */
export function zoomTimeline(factor: number) {
  const { start, end } = timeView.value;
  const isVisible = playhead.value >= start && playhead.value <= end;
  const centre = isVisible ? playhead.value : (start + end) / 2;
  timeView.value = zoomAt(timeView.value, centre, factor, clip.value?.frames ?? 1);
}
