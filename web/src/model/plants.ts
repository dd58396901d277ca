import { firstIndexWhere } from "../util/binary-search";
import { pushRanges } from "./intervals";
import type { Detection, Part, Side, Track } from "./types";

/** One stay of one foot on the ground, frames half-open. */
export interface Plant {
  /** Counts from 1 in order of time, both feet together. */
  number: number;
  side: Side;
  start: number;
  end: number;
  /** Mean probability that its frames are labelled rightly, 0.5 … 1. */
  confidence: number;
  /** A person wants it so. */
  edited: boolean;
}

/** A frame less certain than this is doubtful. */
const certainFrame = 0.75;

/** A plant whose frames are less certain than this on the mean deserves a second look. */
export const certainPlant = 0.95;

/** The part that says best where a foot is planted, of those that are labelled. */
export function principalPart(parts: Partial<Record<Part, unknown>>): Part | undefined {
  return (["contact", "toe", "heel"] as const).find((part) => parts[part]);
}

export function principalTracks<T>(parts: Partial<Record<Part, T>>): T | undefined {
  const part = principalPart(parts);
  return part && parts[part];
}

export function plantsOf(detection: Detection): Plant[] {
  const tracks = principalTracks(detection.parts);
  const plants: Plant[] = [];
  if (!tracks) return plants;
  for (const side of ["left", "right"] as const) {
    const { intervals, confidence, edited } = tracks[side];
    for (let i = 0; i + 1 < intervals.length; i += 2) {
      const [start, end] = [intervals[i] as number, intervals[i + 1] as number];
      plants.push({
        number: 0,
        side,
        start,
        end,
        confidence: mean(confidence, start, end),
        edited: edited[i / 2] === 1,
      });
    }
  }
  plants.sort((a, b) => a.start - b.start || a.end - b.end);
  plants.forEach((plant, i) => {
    plant.number = i + 1;
  });
  return plants;
}

function mean(values: Float32Array, start: number, end: number): number {
  let sum = 0;
  for (let i = start; i < end; i++) sum += values[i] ?? 0;
  return end > start ? sum / (end - start) : 0;
}

/** The plant that holds a frame; of both feet's the later one. */
export function plantAt(plants: readonly Plant[], frame: number, side?: Side): Plant | undefined {
  // One foot's plants never overlap: only the last that has begun can hold the frame.
  let left = side !== "right";
  let right = side !== "left";
  let i = firstIndexWhere(plants.length, (place) => (plants[place] as Plant).start > frame);
  while (i-- > 0 && (left || right)) {
    const plant = plants[i] as Plant;
    if (!(plant.side === "left" ? left : right)) continue;
    if (frame < plant.end) return plant;
    if (plant.side === "left") left = false;
    else right = false;
  }
  return undefined;
}

/** The plants that a stretch of frames holds some of, of one foot. */
export function plantsWithin(
  plants: readonly Plant[],
  side: Side,
  { start, end }: { start: number; end: number },
): Plant[] {
  const first = plantAt(plants, start, side);
  const found = first ? [first] : [];
  let i = firstIndexWhere(plants.length, (place) => (plants[place] as Plant).start > start);
  for (; i < plants.length; i++) {
    const plant = plants[i] as Plant;
    if (plant.start >= end) break;
    if (plant.side === side) found.push(plant);
  }
  return found;
}

/** Every frame where a plant begins or ends, ascending, each once. */
export function plantEdges(plants: readonly Plant[], frames: number): number[] {
  const edges = new Set<number>();
  for (const { start, end } of plants) {
    edges.add(start);
    edges.add(Math.min(end, frames - 1));
  }
  return [...edges].sort((a, b) => a - b);
}

/** The edge next to a frame in the given direction, or undefined at the end. */
export function nextEdge(edges: readonly number[], frame: number, direction: 1 | -1) {
  if (direction > 0) return edges.find((edge) => edge > frame);
  return edges.findLast((edge) => edge < frame);
}

/** Share of frames planted, 0 … 1. */
export function plantedFraction(track: Track): number {
  const { planted, intervals } = track;
  let sum = 0;
  for (let i = 0; i + 1 < intervals.length; i += 2) {
    sum += (intervals[i + 1] as number) - (intervals[i] as number);
  }
  return planted.length ? sum / planted.length : 0;
}

/** How planted a moment is, 0 … 1: the labels averaged over ± `reach` frames, so that light swells and fades. */
export function contactWeight(planted: Uint8Array, frame: number, reach: number): number {
  const from = Math.max(0, frame - reach);
  const to = Math.min(planted.length, frame + reach);
  if (to <= from) return planted[Math.floor(frame)] ?? 0;
  let sum = 0;
  for (let i = Math.floor(from); i < to; i++) {
    const covered = Math.min(i + 1, to) - Math.max(i, from);
    sum += (planted[i] ?? 0) * covered;
  }
  return sum / (to - from);
}

/** Stretches of planted frames that are not certain: start, end, start, end … */
export function uncertainRanges(intervals: Uint32Array, confidence: Float32Array): Uint32Array {
  const found: number[] = [];
  for (let plant = 0; plant < intervals.length; plant += 2) {
    const [start, end] = [intervals[plant] as number, intervals[plant + 1] as number];
    pushRanges(found, start, end, (i) => (confidence[i] as number) < certainFrame);
  }
  return Uint32Array.from(found);
}
