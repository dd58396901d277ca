import type { Edit, Part, Side } from "../worker/types";
import { firstAfter } from "./crowd";
import { intervalAt } from "./plants";

/** Frames, half-open. */
export interface Span {
  start: number;
  end: number;
}

/** One stay of one part of a foot on the ground: what a bar of the timeline shows. */
export interface Stay extends Span {
  side: Side;
  part: Part;
}

/** Where a part of a foot is planted, and how long the clip is. */
export interface Lane {
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
export function resized(lane: Lane, stay: Stay, to: Span): Edit[] {
  const start = clamp(to.start, 0, lane.frames - 1);
  const end = clamp(to.end, start + 1, lane.frames);
  const joined = { start, end };
  // A plant that only touches is the same plant too.
  for (const other of spansOf(lane.intervals)) {
    if (other.start === stay.start || other.end < start || other.start > end) continue;
    joined.start = Math.min(joined.start, other.start);
    joined.end = Math.max(joined.end, other.end);
  }
  const given: Edit[] = [];
  if (stay.start < joined.start)
    given.push(stroke(stay, stay.start, Math.min(stay.end, joined.start), false));
  if (stay.end > joined.end)
    given.push(stroke(stay, Math.max(stay.start, joined.end), stay.end, false));
  return [...given, ...pinned(stay, joined, lane.frames)];
}

/** The edits that part a stay in two around one frame without a plant; none at its edges. */
export function split(lane: Lane, stay: Stay, frame: number): Edit[] {
  if (frame <= stay.start || frame >= stay.end - 1) return [];
  return [...pinned(stay, stay, lane.frames), stroke(stay, frame, frame + 1, false)];
}

/** The edits that join a stay with the next one; none where there is no next one. */
export function merged(lane: Lane, stay: Stay): Edit[] {
  const next = stayAfter(lane, stay);
  return next ? pinned(stay, { start: stay.start, end: next.end }, lane.frames) : [];
}

/** The edits that say a stay is none. */
export function removed(stay: Stay): Edit[] {
  return [stroke(stay, stay.start, stay.end, false)];
}

/** The edits that make a stay where there is none: so many frames from one on, up to the next stay. */
export function added(lane: Lane, frame: number, length: number): Edit[] {
  if (intervalAt(lane.intervals, frame) >= 0) return [];
  const at = firstAfter(lane.intervals, frame);
  const next = lane.intervals[at] ?? lane.frames + 1;
  const before = at > 0 ? (lane.intervals[at - 1] ?? 0) : -1;
  // Apart from its neighbours by a frame, or it would be one of them.
  const start = Math.max(frame, before + 1);
  const end = Math.min(start + Math.max(1, Math.round(length)), next - 1, lane.frames);
  return end > start ? pinned(lane, { start, end }, lane.frames) : [];
}

/** The edits but those that made a stay what it is. */
export function withoutThoseOf(edits: readonly Edit[], stay: Stay): readonly Edit[] {
  return edits.filter(
    (edit) => edit.side !== stay.side || edit.end < stay.start || edit.start > stay.end,
  );
}

/** The stay of a lane that holds a frame, or ends or begins nearest to it. */
export function stayAt(lane: Lane, frame: number): Stay | undefined {
  const at = intervalAt(lane.intervals, frame);
  return at < 0 ? undefined : stayIn(lane, at);
}

/** The stay of a lane that has most in common with a span. */
export function sameStay(lane: Lane, span: Span): Stay | undefined {
  let found: Stay | undefined;
  let most = 0;
  for (let at = firstAfter(lane.intervals, span.start); at < lane.intervals.length; at += 2) {
    const stay = stayIn(lane, at);
    if (stay.start >= span.end) break;
    const common = Math.min(stay.end, span.end) - Math.max(stay.start, span.start);
    if (common > most) [found, most] = [stay, common];
  }
  return found;
}

/** The stay that follows another one. */
export function stayAfter(lane: Lane, { end }: Span): Stay | undefined {
  const at = firstAfter(lane.intervals, end);
  return at < lane.intervals.length ? stayIn(lane, at) : undefined;
}

function stayIn(lane: Lane, at: number): Stay {
  const { side, part, intervals } = lane;
  return { side, part, start: intervals[at] ?? 0, end: intervals[at + 1] ?? 0 };
}

/**
 * Says of a span that it is planted, and of the frames beside it that they are not, so that
 * its edges stay where they are when the clip is detected anew.
 */
function pinned(of: Pick<Stay, "side" | "part">, { start, end }: Span, frames: number): Edit[] {
  const pins = [stroke(of, start, end, true)];
  if (start > 0) pins.push(stroke(of, start - 1, start, false));
  if (end < frames) pins.push(stroke(of, end, end + 1, false));
  return pins;
}

function stroke(
  { side, part }: Pick<Stay, "side" | "part">,
  start: number,
  end: number,
  planted: boolean,
): Edit {
  return { side, part, start, end, planted };
}

function* spansOf(intervals: Uint32Array): Generator<Span> {
  for (let i = 0; i + 1 < intervals.length; i += 2) {
    yield { start: intervals[i] ?? 0, end: intervals[i + 1] ?? 0 };
  }
}

const clamp = (value: number, least: number, most: number) =>
  Math.min(Math.max(Math.round(value), least), most);
