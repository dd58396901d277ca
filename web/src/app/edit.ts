/** Correcting labels by hand: every change is a list of edits, and every list can be taken back. */

import { batch, computed, effect, signal } from "@preact/signals";
import {
  added,
  type Lane,
  merged,
  removed,
  resized,
  type Span,
  type Stay,
  sameStay,
  split,
  stayAt,
  withoutThoseOf,
} from "../lib/edits";
import { principalPart } from "../lib/plants";
import type { EditedParts } from "../worker";
import type { Detection, Edit, Part, Side, Track } from "../worker/types";
import { rescore } from "./compare";
import { engine } from "./engine";
import { failTo } from "./failing";
import { pause, seek } from "./playback";
import {
  announcement,
  clip,
  detection,
  edits,
  frame,
  plants,
  reach,
  selected,
  sheetOpen,
  source,
  tab,
} from "./state";

/** A plant that is added lasts so many seconds at first. */
const firstLength = 0.25;

/** The lists of edits before this one, and those taken back. */
const past = signal<readonly (readonly Edit[])[]>([]);
const future = signal<readonly (readonly Edit[])[]>([]);

export const canUndo = computed(() => past.value.length > 0);
export const canRedo = computed(() => future.value.length > 0);

/** The foot that was selected last. */
let lastSide: Side = "left";

effect(() => {
  if (selected.value) lastSide = selected.value.side;
});

/** The track of the part that is chosen, or of any other. */
export function laneOf({ side, part }: { side: Side; part: Part }): Lane | undefined {
  const tracks = detection.value?.parts[part];
  const frames = clip.value?.frames ?? 0;
  return tracks && { side, part, intervals: tracks[side].intervals, frames };
}

/** What is selected with its lane, and its number where it is a plant. */
export const selection = computed(() => {
  const stay = selected.value;
  const lane = stay && laneOf(stay);
  const tracks = stay && detection.value?.parts[stay.part];
  if (!stay || !lane || !tracks) return undefined;
  const isPrincipal = stay.part === principalPart(detection.value?.parts ?? {});
  const plant =
    isPrincipal && plants.value.find((p) => p.side === stay.side && p.start === stay.start);
  return {
    stay,
    lane,
    number: plant ? plant.number : undefined,
    isEdited: isEdited(tracks[stay.side], stay),
  };
});

function isEdited({ intervals, edited }: Track, { start }: Span): boolean {
  for (let i = 0; i < intervals.length; i += 2) {
    if (intervals[i] === start) return edited[i / 2] === 1;
  }
  return false;
}

/** Gives the clip on show edits that were kept, or none; nothing of that can be taken back. */
export function startEdits(kept: readonly Edit[]): Promise<void> {
  batch(() => {
    past.value = [];
    future.value = [];
    selected.value = null;
    reach.value = null;
    edits.value = kept;
  });
  return kept.length ? show() : Promise.resolve();
}

function commit(next: readonly Edit[], said: string, then?: Span): Promise<void> {
  batch(() => {
    past.value = [...past.value, edits.value];
    future.value = [];
    edits.value = next;
    if (then && selected.value) selected.value = { ...selected.value, ...then };
    announcement.value = said;
  });
  return show();
}

export const undo = () => goTo(past, future, "Undone");
export const redo = () => goTo(future, past, "Done again");

function goTo(from: typeof past, to: typeof past, said: string) {
  const next = from.value.at(-1);
  if (!next) return;
  batch(() => {
    from.value = from.value.slice(0, -1);
    to.value = [...to.value, edits.value];
    edits.value = next;
    announcement.value = said;
  });
  void show();
}

/** Shows the labels under the edits; an answer that comes too late for them is dropped. */
async function show(): Promise<void> {
  const [about, asked] = [source.value, edits.value];
  try {
    const parts = await engine.edit([...asked]);
    if (source.value !== about || edits.value !== asked) return;
    batch(() => {
      if (detection.value) detection.value = withParts(detection.value, parts);
      follow();
    });
    await rescore();
  } catch (error) {
    if (source.value === about) failTo("edited", about?.name ?? "", error);
  }
}

function withParts(before: Detection, parts: EditedParts): Detection {
  const after: Detection["parts"] = {};
  for (const part of Object.keys(before.parts) as Part[]) {
    const [was, now] = [before.parts[part], parts[part]];
    if (was && now) {
      after[part] = { left: { ...was.left, ...now.left }, right: { ...was.right, ...now.right } };
    }
  }
  return { ...before, parts: after };
}

/** What is selected is the stay that is now where it was. */
export function follow() {
  const stay = selected.value;
  const lane = stay && laneOf(stay);
  selected.value = (lane && sameStay(lane, stay)) ?? null;
}

export function select(stay: Stay | undefined) {
  selected.value = stay ?? null;
}

/** Selects the bar under the playhead, or the next one there: contact before heel and toe, left before right. */
export function selectHere() {
  const parts = ["contact", "heel", "toe"] as const;
  const here = (["left", "right"] as const)
    .flatMap((side) => parts.map((part) => laneOf({ side, part })))
    .map((lane) => lane && stayAt(lane, frame.value))
    .filter((stay) => stay !== undefined);
  const at = here.findIndex(
    ({ side, part }) => side === selected.value?.side && part === selected.value.part,
  );
  const next = here[(at + 1) % here.length];
  selected.value = next ?? null;
  announcement.value = next
    ? `${next.side} ${next.part} selected, frames ${next.start} to ${next.end}`
    : "No foot is planted here";
}

/** Gives what is selected other edges. */
export function resize(to: Partial<Span>): Promise<void> | undefined {
  const held = selection.value;
  if (!held) return undefined;
  const { stay, lane } = held;
  const span = { start: to.start ?? stay.start, end: to.end ?? stay.end };
  if (span.start === stay.start && span.end === stay.end) return undefined;
  if (span.start >= span.end) {
    announcement.value = "It would end before it starts";
    return undefined;
  }
  const next = [...edits.value, ...resized(lane, stay, span)];
  return commit(next, `Frames ${span.start} to ${span.end}`, span);
}

/** The frame under the playhead becomes the first or the last one of what is selected. */
export const startHere = () => resize({ start: frame.value });
export const endHere = () => resize({ end: frame.value + 1 });

export function splitHere() {
  change(
    ({ lane, stay }) => split(lane, stay, frame.value),
    "Split",
    "Put the playhead inside it first",
  );
}

export function mergeNext() {
  change(
    ({ lane, stay }) => merged(lane, stay),
    "Merged with the next one",
    "There is no next one",
  );
}

export function remove() {
  change(({ stay }) => removed(stay), "Deleted", "");
}

function change(
  make: (held: { lane: Lane; stay: Stay }) => Edit[],
  said: string,
  otherwise: string,
) {
  const held = selection.value;
  const made = held ? make(held) : [];
  if (made.length) void commit([...edits.value, ...made], said);
  else announcement.value = held ? otherwise : "Select a plant first";
}

/** What is selected becomes again what was detected. */
export function restore() {
  const stay = selected.value;
  if (stay) void commit(withoutThoseOf(edits.value, stay), "As detected");
}

/** All labels become again what was detected. */
export function restoreAll() {
  if (edits.value.length) void commit([], "All as detected");
}

/** A plant of a foot from the playhead on. */
export function addHere(side: Side, part: Part) {
  const lane = laneOf({ side, part });
  if (!lane) return;
  const made = added(lane, frame.value, firstLength * (clip.value?.rate ?? 1));
  const [first] = made;
  if (!first) {
    announcement.value = `The ${side} foot is planted here already`;
    return;
  }
  selected.value = { side, part, start: first.start, end: first.end };
  void commit(
    [...edits.value, ...made],
    `${side} ${part} added, frames ${first.start} to ${first.end}`,
  );
}

/** The same of the foot that was selected last, of the left one before any was. */
export function addAgain() {
  const part = principalPart(detection.value?.parts ?? {});
  if (part) addHere(lastSide, selected.value?.part ?? part);
}

/** Someone else's labels become one's own. */
export async function takeTheirs(): Promise<void> {
  const about = source.value;
  const theirs = await engine.theirs();
  if (source.value === about && theirs.length) await commit(theirs, "Their labels are yours now");
}

/** Takes a person to the fields of a bar. */
export function askForEdges(stay: Stay) {
  batch(() => {
    pause();
    selected.value = stay;
    seek(stay.start);
    tab.value = "labels";
    sheetOpen.value = true;
  });
}
