/** Records of edits and names in the storage of the browser: schema, validation, merging. */

import { randomId } from "../../util/random-id";
import type { StoredChanges } from "../batch/batch";
import { type AnyEdit, isCutEdit } from "../segments/cut-edits";
import type { SegmentName } from "../segments/segments";
import type { CutEdit, Edit, Instant } from "../types";

/** Returns the key of the record of a file. */
export const keyOfHash = (hash: string) => `plantigrade:clip:${hash}`;

/** Version of the records that this app writes. */
const currentVersion = 5;

/**
 * The edits and names of one clip as stored. Version 1 had no revisions, version 2 no edits of cuts, version 3
 * no instants of boundaries, version 4 did not state whether similar plants are settled.
 */
export interface StoredClip extends StoredChanges {
  version: typeof currentVersion;
  /** Identifies this state of the record. */
  revision: string;
  /** The revisions from which this one was made, the newest first. */
  ancestors: readonly string[];
  /** Name of the file, for people who inspect the storage. */
  name: string;
  /** True if the user has applied these edits to similar plants, or has declined to. */
  similarSettled: boolean;
}

/** A record that a newer version of the app has written, or that is damaged. */
export interface UnreadableRecord {
  kind: "newer" | "malformed";
  text: string;
}

/** The first version that states whether similar plants are settled. */
const firstWithSimilar = 5;

/** The content of a storage key. */
export type StoredRecord =
  | { kind: "none" }
  | { kind: "valid"; record: StoredClip }
  | UnreadableRecord;

export const noChanges: StoredChanges = { edits: [], names: [] };

/** Parses a record; `text` is null if there is none. */
export function parseRecord(text: string | null): StoredRecord {
  if (text === null) return { kind: "none" };
  const value = parseJson(text);
  if (!isObject(value)) return { kind: "malformed", text };
  const { version } = value;
  if (Number.isInteger(version) && Number(version) > currentVersion) return { kind: "newer", text };
  const { name, revision, ancestors } =
    version === 1 ? { ...value, ...firstRevision(text) } : value;
  const { similarSettled } = Number(version) < firstWithSimilar ? { similarSettled: false } : value;
  const changes = parseChanges(value);
  const isValid =
    [1, 2, 3, 4, currentVersion].includes(version as number) &&
    changes &&
    typeof name === "string" &&
    typeof revision === "string" &&
    typeof similarSettled === "boolean" &&
    Array.isArray(ancestors) &&
    ancestors.every((ancestor) => typeof ancestor === "string");
  if (!isValid) return { kind: "malformed", text };
  return {
    kind: "valid",
    record: { version: currentVersion, revision, ancestors, name, similarSettled, ...changes },
  };
}

/** Returns the revision of a record of version 1: a hash (FNV-1a), so that all pages agree on it. */
function firstRevision(text: string) {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return { revision: `1-${hash >>> 0}`, ancestors: [] };
}

/** Number of ancestors that a record lists. */
const maxAncestors = 50;

/** Returns the record that follows a revision. */
export const nextRecord = (
  { revision, ancestors }: Pick<StoredClip, "revision" | "ancestors">,
  name: string,
  { edits, names, similarSettled }: StoredChanges & Pick<StoredClip, "similarSettled">,
): StoredClip => ({
  version: currentVersion,
  revision: randomId(),
  ancestors: [revision, ...ancestors].filter(Boolean).slice(0, maxAncestors),
  name,
  similarSettled,
  edits,
  names,
});

/** Returns the edits and names of an object from outside, or undefined if any is invalid. */
export function parseChanges(value: unknown): StoredChanges | undefined {
  if (!isObject(value)) return undefined;
  const { edits, names } = value;
  if (!Array.isArray(edits) || !edits.every(isAnyEdit)) return undefined;
  if (!Array.isArray(names) || !names.every(isSegmentName)) return undefined;
  return {
    edits: edits.map(copyEdit),
    names: names.map((name) => pick(name, "start", "end", "name")),
  };
}

/** Returns an object with some of its fields only. */
const pick = <T extends object, K extends keyof T>(value: T, ...fields: K[]) =>
  Object.fromEntries(fields.map((field) => [field, value[field]])) as Pick<T, K>;

/** Returns an edit without other fields. */
function copyEdit(edit: AnyEdit): AnyEdit {
  if (isCutEdit(edit)) return pick(edit, "cut", "present");
  const copy = pick(edit, "side", "part", "start", "end", "planted");
  const instants = edit.instants?.map((instant) =>
    pick(instant, "side", "part", "frame", "time", "uncertainty"),
  );
  return instants ? { ...copy, instants } : copy;
}

function parseJson(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** Frame numbers are 32 bits wide in the core. */
const maxFrame = 2 ** 32 - 1;

const isFrame = (value: unknown) =>
  Number.isInteger(value) && Number(value) >= 0 && Number(value) <= maxFrame;

function isRange({ start, end }: Record<string, unknown>): boolean {
  return isFrame(start) && isFrame(end) && Number(start) < Number(end);
}

function isEdit(value: unknown): value is Edit {
  return (
    isObject(value) &&
    isRange(value) &&
    isPartOfFoot(value) &&
    typeof value.planted === "boolean" &&
    (value.instants === undefined ||
      (Array.isArray(value.instants) && value.instants.every(isInstant)))
  );
}

const isPartOfFoot = ({ side, part }: Record<string, unknown>) =>
  ["left", "right"].includes(side as string) && ["contact", "heel", "toe"].includes(part as string);

const isInstant = (value: unknown): value is Instant =>
  isObject(value) &&
  isPartOfFoot(value) &&
  isFrame(value.frame) &&
  Number.isFinite(value.time) &&
  Number.isFinite(value.uncertainty);

function isAnyEdit(value: unknown): value is AnyEdit {
  return isEdit(value) || isValidCutEdit(value);
}

function isValidCutEdit(value: unknown): value is CutEdit {
  return (
    isObject(value) &&
    !("side" in value) &&
    isFrame(value.cut) &&
    typeof value.present === "boolean"
  );
}

function isSegmentName(value: unknown): value is SegmentName {
  return isObject(value) && isRange(value) && typeof value.name === "string";
}

/**
 * Merges two lists that were changed independently: `remote`, without the items of `base` that
 * `local` lacks, and then the items that `local` adds.
 */
export function mergeLists<T extends object>(
  base: readonly T[],
  local: readonly T[],
  remote: readonly T[],
): readonly T[] {
  const prefix = commonPrefix(base, local);
  const [before, after] = [base.slice(prefix), local.slice(prefix)];
  const removed = without(before, after);
  // An item that both sides added is not repeated.
  const added = without(without(after, before), without(remote, base));
  return removed.length || added.length ? [...without(remote, removed), ...added] : remote;
}

const keyOf = (item: object) => JSON.stringify(item);

function commonPrefix(a: readonly object[], b: readonly object[]): number {
  const isSame = (x: object | undefined, y: object | undefined) =>
    x === y || (x && y && keyOf(x) === keyOf(y));
  const length = Math.min(a.length, b.length);
  for (let i = 0; i < length; i++) if (!isSame(a[i], b[i])) return i;
  return length;
}

/** Returns a list without one occurrence of each item of another list. */
function without<T extends object>(list: readonly T[], others: readonly T[]): readonly T[] {
  if (!list.length || !others.length) return list;
  const counts = new Map<string, number>();
  for (const other of others) counts.set(keyOf(other), (counts.get(keyOf(other)) ?? 0) + 1);
  return list.filter((item) => {
    const count = counts.get(keyOf(item)) ?? 0;
    if (count) counts.set(keyOf(item), count - 1);
    return !count;
  });
}

/** Merges edits and names that were changed independently. */
export const mergeChanges = (
  base: StoredChanges,
  local: StoredChanges,
  remote: StoredChanges,
): StoredChanges => ({
  edits: mergeLists(base.edits, local.edits, remote.edits),
  names: mergeNames(base.names, local.names, remote.names),
});

/** Merges names; of two names of the same range, that of `local` remains. */
function mergeNames(
  base: readonly SegmentName[],
  local: readonly SegmentName[],
  remote: readonly SegmentName[],
): readonly SegmentName[] {
  const merged = mergeLists(base, local, remote);
  const lastOf = new Map(merged.map((name) => [`${name.start}-${name.end}`, name]));
  return lastOf.size === merged.length ? merged : [...lastOf.values()];
}

/** True if two sets of changes have the same content, in any order. */
export function sameChanges(a: StoredChanges, b: StoredChanges): boolean {
  const isSame = (x: readonly object[], y: readonly object[]) =>
    x === y || (x.length === y.length && without<object>(x, y).length === 0);
  return isSame(a.edits, b.edits) && isSame(a.names, b.names);
}

/** True if both sides added edits that overlap: of the same foot and frames, or of the same cut. */
export function isConflict(
  base: StoredChanges,
  local: StoredChanges,
  remote: StoredChanges,
): boolean {
  const remoteEdits = without(without(remote.edits, base.edits), local.edits);
  const localEdits = without(without(local.edits, base.edits), remote.edits);
  return localEdits.some((local) =>
    remoteEdits.some((other) =>
      isCutEdit(local) || isCutEdit(other)
        ? isCutEdit(local) && isCutEdit(other) && local.cut === other.cut
        : other.side === local.side && other.start < local.end && local.start < other.end,
    ),
  );
}
