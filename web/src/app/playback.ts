import { batch } from "@preact/signals";
import { nextEdge, type Plant, plantAt } from "../lib/plants";
import { type Action, actionAt, kindText } from "../lib/segments";
import { clampView, follow as turnPage, zoomAt } from "../lib/timeView";
import {
  actions,
  announcement,
  clip,
  cuts,
  edges,
  frame,
  hero,
  loop,
  looped,
  loopRegion,
  plants,
  playhead,
  playing,
  speed,
  timeView,
} from "./state";

export const speeds = [0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 4] as const;

export const prefersStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

let before = 0;

const lastFrame = () => Math.max(0, (clip.value?.frames ?? 0) - 1);

function tick(now: number) {
  const held = clip.value;
  if (!playing.value || !held || held.frames < 2) {
    playing.value = false;
    return;
  }
  // A tab that slept must not leap ahead, and the first picture may be dated before the start.
  const elapsed = Math.min(Math.max(0, now - before) / 1000, 0.25);
  before = now;
  const region = hero.value ? null : looped.value;
  const start = region?.start ?? 0;
  const end = region ? Math.min(region.end, lastFrame()) : lastFrame();
  let next = playhead.value + elapsed * held.rate * (hero.value ? 1 : speed.value);
  if (next >= end) {
    if (loop.value === "off" && !hero.value) {
      playing.value = false;
      next = end;
    } else {
      next = end > start ? start + ((next - start) % (end - start)) : start;
    }
  }
  show(next);
  requestAnimationFrame(tick);
}

function show(next: number) {
  playhead.value = next;
  const view = turnPage(timeView.value, next, clip.value?.frames ?? 1);
  if (view !== timeView.value) timeView.value = view;
}

export function play() {
  if (playing.value || lastFrame() < 1) return;
  if (loop.value === "off" && playhead.value >= lastFrame()) playhead.value = 0;
  playing.value = true;
  before = performance.now();
  requestAnimationFrame(tick);
}

export function pause() {
  playing.value = false;
}

export const togglePlay = () => (playing.value ? pause() : play());

/** Goes to a moment; the timeline turns its page to it. */
export function seek(to: number) {
  show(Math.min(Math.max(to, 0), lastFrame()));
}

export function step(by: number) {
  pause();
  seek(frame.value + by);
}

export function stepEdge(direction: 1 | -1) {
  pause();
  const edge = nextEdge(edges.value, frame.value, direction);
  seek(edge ?? (direction > 0 ? lastFrame() : 0));
}

export function seekPlant(plant: Plant) {
  batch(() => {
    seek(plant.start);
    if (loop.value === "plant") loopRegion.value = plant;
    announcement.value = `Plant ${plant.number}, ${plant.side} foot, frames ${plant.start} to ${plant.end}`;
  });
}

/** Goes to the previous or the next cut between segments, or to the end of the clip. */
export function stepCut(direction: 1 | -1) {
  pause();
  seek(nextEdge(cuts.value, frame.value, direction) ?? (direction > 0 ? lastFrame() : 0));
}

/** Goes to the start of a segment and repeats it. */
export function loopSegment(action: Action) {
  batch(() => {
    loopRegion.value = action;
    loop.value = "segment";
    seek(action.start);
    const words = [action.name, kindText(action)].filter(Boolean).join(", ");
    announcement.value = `Segment ${action.number}${words && `, ${words}`}, frames ${action.start} to ${action.end}`;
  });
}

/** The segment under the playhead. */
export const segmentHere = () => actionAt(actions.value, frame.value);

export function changeSpeed(direction: 1 | -1) {
  const nearest = speeds.findIndex((s) => s >= speed.value);
  const next = speeds[Math.min(Math.max(nearest + direction, 0), speeds.length - 1)];
  if (next) speed.value = next;
}

/** Off → the clip → the plant under the playhead (or the next one) → the segment there → off. */
export function cycleLoop() {
  const at = playhead.value;
  const plant = plantAt(plants.value, at) ?? plants.value.find((p) => p.start >= at);
  const regions = { plant, segment: segmentHere() };
  const order = ["off", "clip", "plant", "segment"] as const;
  const next = order
    .slice(order.indexOf(loop.value) + 1)
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

/** Zooms with the playhead held still, or the middle where it is out of sight. */
export function zoomTimeline(factor: number) {
  const { start, end } = timeView.value;
  const at = playhead.value >= start && playhead.value <= end ? playhead.value : (start + end) / 2;
  timeView.value = zoomAt(timeView.value, at, factor, clip.value?.frames ?? 1);
}
