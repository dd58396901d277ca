import { firstIndexWhere } from "../util/binary-search";
import type { Segment } from "./types";

/** One action of the clip as it is shown. */
export interface NamedSegment extends Segment {
  /** Counts from 1. */
  number: number;
  /** What a person calls it; empty where nobody has named it. */
  name: string;
}

/** A name that a person gave to some frames, half-open. */
export interface SegmentName {
  start: number;
  end: number;
  name: string;
}

interface Span {
  start: number;
  end: number;
}

/**
 * How much of the longer of two spans both have in common. Above a half they are the same
 * action, and of each other's segments no other one can be.
 */
function overlap(a: Span, b: Span): number {
  const common = Math.min(a.end, b.end) - Math.max(a.start, b.start);
  return common / Math.max(a.end - a.start, b.end - b.start);
}

/** The item that spans the same action, if there is one. */
export function matchingSegment<T extends Span>(items: readonly T[], span: Span): T | undefined {
  let found: T | undefined;
  let most = 0.5;
  for (const item of items) {
    const like = overlap(item, span);
    if (like > most) [found, most] = [item, like];
  }
  return found;
}

/** The segments in order with the names that people gave to those actions. */
export function nameSegments(
  segments: readonly Segment[],
  names: readonly SegmentName[],
): NamedSegment[] {
  return segments.map((segment, i) => ({
    ...segment,
    number: i + 1,
    name: matchingSegment(names, segment)?.name ?? "",
  }));
}

/** The names with that of one action changed; without a name it has none. */
export function renameSegment(
  names: readonly SegmentName[],
  { start, end }: Span,
  name: string,
): SegmentName[] {
  const others = names.filter((other) => overlap(other, { start, end }) <= 0.5);
  return name.trim() ? [...others, { start, end, name }] : others;
}

/** What an action is called on its bar and in files: a person's name, or the method's. */
export const segmentTitle = ({ name, label }: NamedSegment) => name.trim() || label;

/** What kind of action it is, in a word; nothing where the method does not tell. */
export const segmentKind = ({ kind }: Segment) => (kind === "action" ? "" : kind);

/** The action that holds a frame. */
export function segmentAt(
  actions: readonly NamedSegment[],
  frame: number,
): NamedSegment | undefined {
  return actions[segmentIndexAt(actions, frame)];
}

/** Place of the segment that holds a frame, or of the first or the last one. */
export function segmentIndexAt(segments: readonly Span[], frame: number): number {
  const place = firstIndexWhere(segments.length, (i) => (segments[i] as Span).end > frame);
  return Math.max(0, Math.min(place, segments.length - 1));
}

/** The first frame of each action but the first. */
export const cutsOf = (actions: readonly NamedSegment[]) =>
  actions.slice(1).map(({ start }) => start);

/** A file name for each action, in order: `walk-03-turn.bvh`. */
export function segmentFileNames(actions: readonly NamedSegment[], clip: string): string[] {
  const digits = Math.max(2, String(actions.length).length);
  return actions.map((action) => {
    // A person's words may hold what file systems do not.
    const words = action.name
      .trim()
      .replace(/[^\p{L}\p{N}]+/gu, "-")
      .replace(/^-|-$/g, "");
    const parts = [clip, String(action.number).padStart(digits, "0"), words];
    return `${parts.filter(Boolean).join("-")}.bvh`;
  });
}
