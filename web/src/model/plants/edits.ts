import type { Edit, Part, Side } from "../types";
import { firstIntervalAfter, intervalAt } from "./intervals";

/** A range of frames, half-open. */
export interface FrameRange {
  start: number;
  end: number;
}

/** A plant of one part of one foot, shown as a bar of the timeline. */
export interface PlantRef extends FrameRange {
  side: Side;
  part: Part;
}

/** The plants of one part of one foot. */
export interface PartTrack {
  side: Side;
  part: Part;
  /** Plants as frame ranges: start, end, start, end, …. */
  intervals: Uint32Array;
  /** Number of frames of the clip. */
  frames: number;
}

/**
 * Returns edits that change the range of a plant. Frames outside of the new range are no longer
 * planted; plants that overlap or touch it are merged.
 */
export function resizePlant(track: PartTrack, plant: PlantRef, range: FrameRange): Edit[] {
  const start = clamp(range.start, 0, track.frames - 1);
  const end = clamp(range.end, start + 1, track.frames);
  const merged = { start, end };
  for (const other of rangesOf(track.intervals)) {
    if (other.start === plant.start || other.end < start || other.start > end) continue;
    merged.start = Math.min(merged.start, other.start);
    merged.end = Math.max(merged.end, other.end);
  }
  const removed: Edit[] = [];
  if (plant.start < merged.start)
    removed.push(createEdit(plant, plant.start, Math.min(plant.end, merged.start), false));
  if (plant.end > merged.end)
    removed.push(createEdit(plant, Math.max(plant.start, merged.end), plant.end, false));
  return [...removed, ...pinEdges(plant, merged, track.frames)];
}

/**
 * Returns edits that split a plant by a gap of one frame, since labels are per frame; none at its edges. The
 * frames next to the gap are pinned, so that both halves are edited plants; the outer edges stay as they were
 * detected.
 */
export function splitPlant(plant: PlantRef, frame: number): Edit[] {
  if (frame <= plant.start || frame >= plant.end - 1) return [];
  return [
    createEdit(plant, frame - 1, frame, true),
    createEdit(plant, frame + 1, frame + 2, true),
    createEdit(plant, frame, frame + 1, false),
  ];
}

/**
 * Returns the edits with a plant joined with the next one; undefined if it is the last. Joining the halves
 * of a split removes its edits, so that the plant is as before.
 */
export function joinWithNext(
  edits: readonly Edit[],
  track: PartTrack,
  plant: PlantRef,
): readonly Edit[] | undefined {
  const next = nextPlantRef(track, plant);
  if (!next) return undefined;
  const whole = { ...plant, end: next.end };
  const split = next.start - plant.end === 1 ? splitPlant(whole, plant.end) : [];
  const found = split.map((part) => edits.findLast((edit) => isSameEdit(edit, part)));
  if (split.length && found.every((edit) => edit !== undefined))
    return edits.filter((edit) => !found.includes(edit));
  return [...edits, ...pinEdges(plant, { start: plant.start, end: next.end }, track.frames)];
}

const isSameEdit = (a: Edit, b: Edit) =>
  a.side === b.side &&
  a.part === b.part &&
  a.start === b.start &&
  a.end === b.end &&
  a.planted === b.planted;

/** Returns the edit that removes a plant. */
export function removePlant(plant: PlantRef): Edit[] {
  return [createEdit(plant, plant.start, plant.end, false)];
}

/**
 * Returns edits that add a plant of up to `length` frames, at `frame` or as soon after it as is
 * possible without touching other plants; none if the frame is planted.
 */
export function addPlant(track: PartTrack, frame: number, length: number): Edit[] {
  if (intervalAt(track.intervals, frame) >= 0) return [];
  const index = firstIntervalAfter(track.intervals, frame);
  const nextStart = track.intervals[index] ?? track.frames + 1;
  const previousEnd = index > 0 ? (track.intervals[index - 1] ?? 0) : -1;
  // One free frame on each side; otherwise the plants would be merged.
  const start = Math.max(frame, previousEnd + 1);
  const end = Math.min(start + Math.max(1, Math.round(length)), nextStart - 1, track.frames);
  return end > start ? pinEdges(track, { start, end }, track.frames) : [];
}

/** Returns the edits that do not affect a plant. */
export function withoutEditsOf(edits: readonly Edit[], plant: PlantRef): readonly Edit[] {
  return edits.filter(
    (edit) => edit.side !== plant.side || edit.end < plant.start || edit.start > plant.end,
  );
}

/** Returns the plant that contains a frame, if any. */
export function plantRefAt(track: PartTrack, frame: number): PlantRef | undefined {
  const index = intervalAt(track.intervals, frame);
  return index < 0 ? undefined : plantRefOf(track, index);
}

/** Returns all plants of a track. */
export const plantRefsOf = ({ side, part, intervals }: PartTrack): PlantRef[] =>
  Array.from(rangesOf(intervals), (range) => ({ side, part, ...range }));

/** Returns the plant that shares the most frames with a range, if any. */
export function matchingPlantRef(track: PartTrack, range: FrameRange): PlantRef | undefined {
  let match: PlantRef | undefined;
  let maxOverlap = 0;
  for (
    let index = firstIntervalAfter(track.intervals, range.start);
    index < track.intervals.length;
    index += 2
  ) {
    const plant = plantRefOf(track, index);
    if (plant.start >= range.end) break;
    const overlap = Math.min(plant.end, range.end) - Math.max(plant.start, range.start);
    if (overlap > maxOverlap) [match, maxOverlap] = [plant, overlap];
  }
  return match;
}

/** Returns the first plant after another one, if any. */
export function nextPlantRef(track: PartTrack, { end }: FrameRange): PlantRef | undefined {
  const index = firstIntervalAfter(track.intervals, end);
  return index < track.intervals.length ? plantRefOf(track, index) : undefined;
}

function plantRefOf(track: PartTrack, index: number): PlantRef {
  const { side, part, intervals } = track;
  return { side, part, start: intervals[index] ?? 0, end: intervals[index + 1] ?? 0 };
}

/**
 * Returns edits that make a range planted and its two neighbouring frames not planted, so that its
 * edges do not move when the clip is detected again.
 */
function pinEdges(
  target: Pick<PlantRef, "side" | "part">,
  { start, end }: FrameRange,
  frames: number,
): Edit[] {
  const pins = [createEdit(target, start, end, true)];
  if (start > 0) pins.push(createEdit(target, start - 1, start, false));
  if (end < frames) pins.push(createEdit(target, end, end + 1, false));
  return pins;
}

function createEdit(
  { side, part }: Pick<PlantRef, "side" | "part">,
  start: number,
  end: number,
  planted: boolean,
): Edit {
  return { side, part, start, end, planted };
}

function* rangesOf(intervals: Uint32Array): Generator<FrameRange> {
  for (let i = 0; i + 1 < intervals.length; i += 2) {
    yield { start: intervals[i] ?? 0, end: intervals[i + 1] ?? 0 };
  }
}

const clamp = (value: number, min: number, max: number) =>
  Math.min(Math.max(Math.round(value), min), max);
