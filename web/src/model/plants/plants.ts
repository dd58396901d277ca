import { firstIndexWhere } from "../../util/binary-search";
import type { Detection, Labels, Part, Side, Track } from "../types";
import type { FrameRange } from "./edits";
import { pushRanges } from "./intervals";

/** A plant of the principal part of one foot; frames half-open. */
export interface Plant {
  /** Number from 1 in order of time, over both feet. */
  number: number;
  side: Side;
  start: number;
  end: number;
  /** Mean probability that the labels of its frames are correct, 0.5 to 1. */
  confidence: number;
  /** True if an edit determines it. */
  edited: boolean;
  /** Foot strike and foot off, if they are known more exactly than the frames. */
  strike: Instant | undefined;
  off: Instant | undefined;
}

/** An instant with the standard deviation of its error, in seconds. */
export interface Instant {
  time: number;
  uncertainty: number;
}

/** Frames of lower confidence are marked as uncertain. */
const minFrameConfidence = 0.75;

/** Plants of lower mean confidence are marked as uncertain. */
export const minPlantConfidence = 0.95;

/** Returns the labelled part that is used for the foot as a whole: contact, else toe, else heel. */
export function principalPart(parts: Partial<Record<Part, unknown>>): Part | undefined {
  return (["contact", "toe", "heel"] as const).find((part) => parts[part]);
}

/** Returns the entry of the principal part. */
export function principalTracks<T>(parts: Partial<Record<Part, T>>): T | undefined {
  const part = principalPart(parts);
  return part && parts[part];
}

/** Returns the plants of the principal part of both feet, in order of time. */
export function plantsOf(detection: Detection): Plant[] {
  const tracks = principalTracks(detection.parts);
  const plants: Plant[] = [];
  if (!tracks) return plants;
  for (const side of ["left", "right"] as const) {
    const { intervals, instants, confidence, edited } = tracks[side];
    for (let i = 0; i + 1 < intervals.length; i += 2) {
      const [start, end] = [intervals[i] as number, intervals[i + 1] as number];
      plants.push({
        number: 0,
        side,
        start,
        end,
        confidence: mean(confidence, start, end),
        edited: edited[i / 2] === 1,
        strike: instantAt(instants, 2 * i),
        off: instantAt(instants, 2 * i + 2),
      });
    }
  }
  plants.sort((a, b) => a.start - b.start || a.end - b.end);
  plants.forEach((plant, i) => {
    plant.number = i + 1;
  });
  return plants;
}

/** Returns the instants of the plant of a part that starts at a frame. */
export function instantsOf({ intervals, instants }: Labels, start: number) {
  for (let i = 0; i < intervals.length; i += 2) {
    if (intervals[i] !== start) continue;
    return { strike: instantAt(instants, 2 * i), off: instantAt(instants, 2 * i + 2) };
  }
  return { strike: undefined, off: undefined };
}

function instantAt(instants: Float64Array, index: number): Instant | undefined {
  const time = instants[index] ?? Number.NaN;
  return Number.isNaN(time) ? undefined : { time, uncertainty: instants[index + 1] as number };
}

function mean(values: Float32Array, start: number, end: number): number {
  let sum = 0;
  for (let i = start; i < end; i++) sum += values[i] ?? 0;
  return end > start ? sum / (end - start) : 0;
}

/** Returns the plant that contains a frame; if both feet are planted, the one that started later. */
export function plantAt(plants: readonly Plant[], frame: number, side?: Side): Plant | undefined {
  // Plants of one foot do not overlap: only the last one that has started can contain the frame.
  const pending = { left: side !== "right", right: side !== "left" };
  let i = firstIndexAfter(plants, frame);
  while (i-- > 0 && (pending.left || pending.right)) {
    const plant = plants[i] as Plant;
    if (!pending[plant.side]) continue;
    if (frame < plant.end) return plant;
    pending[plant.side] = false;
  }
  return undefined;
}

/** Returns the index of the first plant that starts after a frame. */
function firstIndexAfter(plants: readonly Plant[], frame: number): number {
  return firstIndexWhere(plants.length, (i) => (plants[i] as Plant).start > frame);
}

/** Returns the plants of one foot that overlap a range of frames. */
export function plantsWithin(
  plants: readonly Plant[],
  side: Side,
  { start, end }: { start: number; end: number },
): Plant[] {
  const first = plantAt(plants, start, side);
  const overlapping = first ? [first] : [];
  for (let i = firstIndexAfter(plants, start); i < plants.length; i++) {
    const plant = plants[i] as Plant;
    if (plant.start >= end) break;
    if (plant.side === side) overlapping.push(plant);
  }
  return overlapping;
}

/** Returns the distinct first and last frames of plants, ascending. */
export function plantEdges(plants: readonly FrameRange[]): number[] {
  const edges = new Set<number>();
  for (const { start, end } of plants) {
    edges.add(start);
    edges.add(end - 1);
  }
  return [...edges].sort((a, b) => a - b);
}

/** Returns the nearest edge before or after a frame; undefined if there is none. */
export function nextEdge(edges: readonly number[], frame: number, direction: 1 | -1) {
  if (direction > 0) return edges.find((edge) => edge > frame);
  return edges.findLast((edge) => edge < frame);
}

/** Returns the fraction of frames that are planted, 0 to 1. */
export function plantedFraction(track: Track): number {
  const { planted, intervals } = track;
  let count = 0;
  for (let i = 0; i + 1 < intervals.length; i += 2) {
    count += (intervals[i + 1] as number) - (intervals[i] as number);
  }
  return planted.length ? count / planted.length : 0;
}

/** Returns the ranges of planted frames with low confidence: start, end, start, end, …. */
export function uncertainRanges(intervals: Uint32Array, confidence: Float32Array): Uint32Array {
  const ranges: number[] = [];
  for (let i = 0; i < intervals.length; i += 2) {
    const [start, end] = [intervals[i] as number, intervals[i + 1] as number];
    pushRanges(ranges, start, end, (frame) => (confidence[frame] as number) < minFrameConfidence);
  }
  return Uint32Array.from(ranges);
}
