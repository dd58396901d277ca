import { firstIndexWhere } from "../../util/binary-search";
import type { FrameRange } from "../plants/edits";
import type { GaitAction, Segment } from "../types";

/** A segment as displayed. */
export interface NamedSegment extends Segment {
  /** Number from 1. */
  number: number;
  /** Name given by the user; empty if there is none. */
  name: string;
}

/** A name that the user gave to a range of frames, half-open. */
export interface SegmentName {
  start: number;
  end: number;
  name: string;
}

/**
 * Returns the overlap of two ranges as a fraction of the longer one. Above one half, both count as
 * the same action; at most one segment of a segmentation exceeds that.
 */
function overlap(a: FrameRange, b: FrameRange): number {
  const common = Math.min(a.end, b.end) - Math.max(a.start, b.start);
  return common / Math.max(a.end - a.start, b.end - b.start);
}

/** Returns the item of which the overlap with a range is more than one half of both, if any. */
export function matchingRange<T extends FrameRange>(
  items: readonly T[],
  range: FrameRange,
): T | undefined {
  let match: T | undefined;
  let maxOverlap = 0.5;
  for (const item of items) {
    const fraction = overlap(item, range);
    if (fraction > maxOverlap) [match, maxOverlap] = [item, fraction];
  }
  return match;
}

/** Letters and names of actions that several clips share. */
export interface Vocabulary {
  /** The common letter of each action of a clip. */
  actions: ReadonlyMap<string, string>;
  /** The names that the user gave to actions, by their common letter. */
  names: ReadonlyMap<string, string>;
}

const emptyVocabulary: Vocabulary = { actions: new Map(), names: new Map() };

/**
 * Numbers the segments and names them: by the name given to the segment, or to the detected one of which it is a
 * piece, or else by the first name given to a segment with the same action, in this clip or else in another one with
 * the same vocabulary. `detected` are the segments before cuts were edited.
 */
export function nameSegments(
  segments: readonly Segment[],
  names: readonly SegmentName[],
  vocabulary = emptyVocabulary,
  detected = segments,
): NamedSegment[] {
  const withCommonActions = (list: readonly Segment[]) =>
    list.map((segment) => ({
      ...segment,
      action: vocabulary.actions.get(segment.action ?? "") ?? segment.action ?? "",
    }));
  const renamed = withCommonActions(segments);
  const nameOf = namesOfActions(renamed, names, withCommonActions(detected));
  return renamed.map((segment, i) => ({
    ...segment,
    number: i + 1,
    name:
      matchingRange(names, segment)?.name ??
      matchingRange(names, originOf(segment, detected))?.name ??
      nameOf.get(segment.action) ??
      vocabulary.names.get(segment.action) ??
      "",
  }));
}

/** Returns the detected segment with which a segment has the most frames in common. */
function originOf(segment: Segment, detected: readonly Segment[]): Segment {
  let [origin, maxCommon] = [segment, 0];
  for (const other of detected.slice(segmentIndexAt(detected, segment.start))) {
    if (other.start >= segment.end) break;
    const common = Math.min(other.end, segment.end) - Math.max(other.start, segment.start);
    if (common > maxCommon) [origin, maxCommon] = [other, common];
  }
  return origin;
}

/** Returns the first name that was given to a segment of each action, detected or cut by the user. */
export function namesOfActions(
  segments: readonly Segment[],
  names: readonly SegmentName[],
  detected = segments,
): Map<string, string> {
  // Detected ones first, since cuts must not take the name of an action.
  const all = [...detected, ...segments];
  const own = all.map((segment) => matchingRange(names, segment));
  const nameOf = new Map<string, string>();
  for (const name of names) {
    const action = all[own.indexOf(name)]?.action;
    if (action && !nameOf.has(action)) nameOf.set(action, name.name);
  }
  return nameOf;
}

/** Replaces the name of one segment; an empty name removes it. */
export function renameSegment(
  names: readonly SegmentName[],
  { start, end }: FrameRange,
  name: string,
): SegmentName[] {
  const isSame = (other: SegmentName) => overlap(other, { start, end }) > 0.5;
  if (!name.trim()) return names.filter((other) => !isSame(other));
  const renamed = { start, end, name };
  // In its place, since the first name of an action is that of the others.
  return names.some(isSame)
    ? names.map((other) => (isSame(other) ? renamed : other))
    : [...names, renamed];
}

/** Returns the name of a segment, or the label of the method if it has none. */
export const segmentTitle = ({ name, label }: NamedSegment) => name.trim() || label;

/** Returns the letter of the action of a segment, with the number of its cycles: `A`, `A, 12 cycles`. */
export function actionText({ action = "", cycles }: Segment): string {
  return cycles ? `${action}, ${Math.round(cycles)} cycles` : action;
}

/** Returns the kind of a segment; empty for a plain action. */
export const segmentKind = ({ kind }: Segment) => (kind === "action" ? "" : kind);

/** Returns the segment that contains a frame, or the first or the last one. */
export function segmentAt(
  segments: readonly NamedSegment[],
  frame: number,
): NamedSegment | undefined {
  return segments[segmentIndexAt(segments, frame)];
}

/** Returns the index of the segment that contains a frame, or of the first or the last one. */
export function segmentIndexAt(segments: readonly FrameRange[], frame: number): number {
  const index = firstIndexWhere(segments.length, (i) => (segments[i] as FrameRange).end > frame);
  return Math.max(0, Math.min(index, segments.length - 1));
}

/** Returns the first frame of every segment except the first. */
export const cutsOf = (segments: readonly NamedSegment[]) =>
  segments.slice(1).map(({ start }) => start);

/**
 * Returns the actions of segments in order of first appearance. Segments with the same action are one action;
 * its name is that of its first segment with a name, or else that of the action.
 */
export function actionsOf(segments: readonly NamedSegment[]): GaitAction[] {
  const byAction = new Map<string, NamedSegment[]>();
  for (const segment of segments) {
    const key = segment.action || segment.label || String(segment.number);
    byAction.set(key, [...(byAction.get(key) ?? []), segment]);
  }
  const actions = [...byAction].map(([key, members]) => ({
    name: members.find(({ name }) => name)?.name ?? key,
    frames: members.flatMap(({ start, end }) => [start, end]),
  }));
  // Two actions may have been given the same name.
  const isTaken = (name: string, i: number) =>
    actions.slice(0, i).some((earlier) => earlier.name === name);
  const keys = [...byAction.keys()];
  return actions.map(({ name, frames }, i) => ({
    name: isTaken(name, i) ? `${name} (${keys[i]})` : name,
    frames,
  }));
}
