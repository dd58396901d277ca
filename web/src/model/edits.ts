import { firstIntervalAfter, intervalAt } from "./intervals";
import type { Edit, Part, Side } from "./types";

/** Frames, half-open. */
export interface FrameRange {
  start: number;
  end: number;
}

/** One stay of one part of a foot on the ground: what a bar of the timeline shows. */
export interface PlantRef extends FrameRange {
  side: Side;
  part: Part;
}

/** Where a part of a foot is planted, and how long the clip is. */
export interface PartTrack {
  side: Side;
  part: Part;
  /** start, end, start, end …, half-open. */
  intervals: Uint32Array;
  frames: number;
}

/**
 * The edits that give a stay other edges. What it gives up is set free; a neighbour that it
 * reaches is taken in.
 */
export function resizePlant(lane: PartTrack, stay: PlantRef, to: FrameRange): Edit[] {
  const start = clamp(to.start, 0, lane.frames - 1);
  const end = clamp(to.end, start + 1, lane.frames);
  const joined = { start, end };
  // A plant that only touches is the same plant too.
  for (const other of rangesOf(lane.intervals)) {
    if (other.start === stay.start || other.end < start || other.start > end) continue;
    joined.start = Math.min(joined.start, other.start);
    joined.end = Math.max(joined.end, other.end);
  }
  const given: Edit[] = [];
  if (stay.start < joined.start)
    given.push(createEdit(stay, stay.start, Math.min(stay.end, joined.start), false));
  if (stay.end > joined.end)
    given.push(createEdit(stay, Math.max(stay.start, joined.end), stay.end, false));
  return [...given, ...pinEdges(stay, joined, lane.frames)];
}

/** The edits that part a stay in two around one frame without a plant; none at its edges. */
export function splitPlant(lane: PartTrack, stay: PlantRef, frame: number): Edit[] {
  if (frame <= stay.start || frame >= stay.end - 1) return [];
  return [...pinEdges(stay, stay, lane.frames), createEdit(stay, frame, frame + 1, false)];
}

/** The edits that join a stay with the next one; none where there is no next one. */
export function mergeWithNext(lane: PartTrack, stay: PlantRef): Edit[] {
  const next = nextPlantRef(lane, stay);
  return next ? pinEdges(stay, { start: stay.start, end: next.end }, lane.frames) : [];
}

/** The edits that say a stay is none. */
export function removePlant(stay: PlantRef): Edit[] {
  return [createEdit(stay, stay.start, stay.end, false)];
}

/** The edits that make a stay where there is none: so many frames from one on, up to the next stay. */
export function addPlant(lane: PartTrack, frame: number, length: number): Edit[] {
  if (intervalAt(lane.intervals, frame) >= 0) return [];
  const at = firstIntervalAfter(lane.intervals, frame);
  const next = lane.intervals[at] ?? lane.frames + 1;
  const before = at > 0 ? (lane.intervals[at - 1] ?? 0) : -1;
  // Apart from its neighbours by a frame, or it would be one of them.
  const start = Math.max(frame, before + 1);
  const end = Math.min(start + Math.max(1, Math.round(length)), next - 1, lane.frames);
  return end > start ? pinEdges(lane, { start, end }, lane.frames) : [];
}

/** The edits but those that made a stay what it is. */
export function withoutEditsOf(edits: readonly Edit[], stay: PlantRef): readonly Edit[] {
  return edits.filter(
    (edit) => edit.side !== stay.side || edit.end < stay.start || edit.start > stay.end,
  );
}

/** The stay of a lane that holds a frame, or ends or begins nearest to it. */
export function plantRefAt(lane: PartTrack, frame: number): PlantRef | undefined {
  const at = intervalAt(lane.intervals, frame);
  return at < 0 ? undefined : plantRefOf(lane, at);
}

/** The stay of a lane that has most in common with a span. */
export function matchingPlantRef(lane: PartTrack, span: FrameRange): PlantRef | undefined {
  let found: PlantRef | undefined;
  let most = 0;
  for (
    let at = firstIntervalAfter(lane.intervals, span.start);
    at < lane.intervals.length;
    at += 2
  ) {
    const stay = plantRefOf(lane, at);
    if (stay.start >= span.end) break;
    const common = Math.min(stay.end, span.end) - Math.max(stay.start, span.start);
    if (common > most) [found, most] = [stay, common];
  }
  return found;
}

/** The stay that follows another one. */
export function nextPlantRef(lane: PartTrack, { end }: FrameRange): PlantRef | undefined {
  const at = firstIntervalAfter(lane.intervals, end);
  return at < lane.intervals.length ? plantRefOf(lane, at) : undefined;
}

function plantRefOf(lane: PartTrack, at: number): PlantRef {
  const { side, part, intervals } = lane;
  return { side, part, start: intervals[at] ?? 0, end: intervals[at + 1] ?? 0 };
}

/**
 * Says of a span that it is planted, and of the frames beside it that they are not, so that
 * its edges stay where they are when the clip is detected anew.
 */
function pinEdges(
  of: Pick<PlantRef, "side" | "part">,
  { start, end }: FrameRange,
  frames: number,
): Edit[] {
  const pins = [createEdit(of, start, end, true)];
  if (start > 0) pins.push(createEdit(of, start - 1, start, false));
  if (end < frames) pins.push(createEdit(of, end, end + 1, false));
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

const clamp = (value: number, least: number, most: number) =>
  Math.min(Math.max(Math.round(value), least), most);
