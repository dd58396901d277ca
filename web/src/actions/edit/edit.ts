/** Editing plants by hand. Each command appends to the list of edits, and can be undone. */

import { batch, computed } from "@preact/signals";
import { engine } from "../../engine";
import {
  addPlant,
  type FrameRange,
  joinWithNext,
  matchingPlantRef,
  type PartTrack,
  type PlantRef,
  plantRefAt,
  plantRefsOf,
  removePlant,
  resizePlant,
  splitPlant,
  withoutEditsOf,
} from "../../model/plants/edits";
import {
  instantsOf,
  minPlantConfidence,
  plantEdges,
  principalPart,
} from "../../model/plants/plants";
import { type AnyEdit, cutEditsOf, plantEditsOf } from "../../model/segments/cut-edits";
import type { Detection, EditedParts, Part, Side, Track } from "../../model/types";
import { type ClipSession, session } from "../../store/clip-session";
import { reportFailure } from "../../store/errors";
import { frame } from "../../store/playback";
import {
  addTarget,
  clip,
  detection,
  edits,
  plantEdits,
  plants,
  selected,
  selectedCut,
  selectedEdge,
} from "../../store/session";
import { announce, notify, showTab } from "../../store/view";
import { capitalize, plural, spokenRange } from "../../util/format";
import { updateScores } from "../analyse/compare";
import { pause, seek, stepThrough } from "../view/playback";
import { applyCutEdits } from "./cuts";
import { findSimilar } from "./find-similar";

/** Initial duration of an added plant, in seconds. */
const addedDuration = 0.25;

export const canUndo = computed(() => session.value.undoStack.value.length > 0);
export const canRedo = computed(() => session.value.redoStack.value.length > 0);

/** Returns the track of a part of a foot, if it is labelled. */
function partTrackOf({ side, part }: { side: Side; part: Part }): PartTrack | undefined {
  const tracks = detection.value?.parts[part];
  const frames = clip.value?.frames ?? 0;
  return tracks && { side, part, intervals: tracks[side].intervals, frames };
}

/** The track to which a plant is added, if any is labelled. */
export const targetTrack = computed(() => {
  const parts = detection.value?.parts ?? {};
  const principal = principalPart(parts);
  const { side = "left", part = principal } = addTarget.value ?? {};
  const labelled = part && parts[part] ? part : principal;
  return labelled && { side, part: labelled };
});

/** The selected plant with its track, and its number if it is of the principal part. */
export const selection = computed(() => {
  const plantRef = selected.value;
  const track = plantRef && partTrackOf(plantRef);
  const tracks = plantRef && detection.value?.parts[plantRef.part];
  if (!plantRef || !track || !tracks) return undefined;
  const isPrincipal = plantRef.part === principalPart(detection.value?.parts ?? {});
  const plant =
    isPrincipal &&
    plants.value.find(({ side, start }) => side === plantRef.side && start === plantRef.start);
  return {
    plantRef,
    track,
    plant: plant || undefined,
    instants: instantsOf(tracks[plantRef.side], plantRef.start),
    isEdited: isEdited(tracks[plantRef.side], plantRef),
  };
});

function isEdited({ intervals, edited }: Track, { start }: FrameRange): boolean {
  for (let i = 0; i < intervals.length; i += 2) {
    if (intervals[i] === start) return edited[i / 2] === 1;
  }
  return false;
}

/**
 * Runs an edit of the open clip when the labels contain the edits before it: an edit is computed from the labels,
 * which the worker updates later. Values that a user sees when giving the command, such as the playhead, must be read
 * before.
 */
export const inOrder = (edit: () => unknown): Promise<void> => session.value.inOrder(edit);

/** Replaces the edits, also those to which undo and redo return. */
export async function replaceEdits(
  clipSession: ClipSession,
  replace: (edits: readonly AnyEdit[]) => readonly AnyEdit[],
): Promise<void> {
  const { edits, undoStack, redoStack } = clipSession;
  const before = edits.value;
  batch(() => {
    edits.value = replace(before);
    undoStack.value = undoStack.value.map(replace);
    redoStack.value = redoStack.value.map(replace);
  });
  if (before.length || edits.value.length) await applyEdits(clipSession);
}

/** What the last edit of a list did. */
const effects = new WeakMap<readonly AnyEdit[], string>();

/** Replaces the edits; this can be undone. */
export function commitEdits(
  next: readonly AnyEdit[],
  message: string,
  range?: FrameRange,
): Promise<void> {
  const clipSession = session.value;
  effects.set(next, message);
  batch(() => {
    clipSession.undoStack.value = [...clipSession.undoStack.value, clipSession.edits.value];
    clipSession.redoStack.value = [];
    clipSession.edits.value = next;
    if (range && clipSession.selected.value)
      clipSession.selected.value = { ...clipSession.selected.value, ...range };
    notify(message);
  });
  return applyEdits(clipSession);
}

export const undo = () => swap("undoStack", "redoStack", "Undone");
export const redo = () => swap("redoStack", "undoStack", "Redone");

type EditStack = "undoStack" | "redoStack";

function swap(from: EditStack, to: EditStack, message: string): Promise<void> {
  return inOrder(async () => {
    const clipSession = session.value;
    const [source, target] = [clipSession[from], clipSession[to]];
    const next = source.value.at(-1);
    if (!next) return;
    const last = clipSession.edits.value;
    batch(() => {
      source.value = source.value.slice(0, -1);
      target.value = [...target.value, last];
      clipSession.edits.value = next;
    });
    const effect = effects.get(from === "undoStack" ? last : next);
    notify(effect ? `${message}: ${effect}` : message);
    await applyEdits(clipSession);
  });
}

/** Applies the edits to the labels, from wherever they are; edits that are given later wait for it. */
function applyEdits(clipSession: ClipSession): Promise<void> {
  const applied = updateLabels(clipSession);
  clipSession.delayEdits(applied);
  return applied;
}

async function updateLabels(clipSession: ClipSession): Promise<void> {
  try {
    const [parts] = await Promise.all([
      clipSession.run("edit", () => engine.edit(plantEditsOf(clipSession.edits.value))),
      applyCutEdits(clipSession),
    ]);
    if (!parts) return;
    batch(() => {
      const before = clipSession.detection.value;
      if (before) clipSession.detection.value = withParts(before, parts);
      followSelection(clipSession);
    });
    await Promise.all([updateScores(clipSession), findSimilar(clipSession)]);
  } catch (error) {
    reportFailure(
      "edited",
      clipSession.source?.name ?? "",
      error,
      () => void applyEdits(clipSession),
    );
  }
}

function withParts(before: Detection, parts: EditedParts): Detection {
  const after: Detection["parts"] = {};
  for (const part of Object.keys(before.parts) as Part[]) {
    const [tracks, labels] = [before.parts[part], parts[part]];
    if (tracks && labels) {
      after[part] = {
        left: { ...tracks.left, ...labels.left },
        right: { ...tracks.right, ...labels.right },
      };
    }
  }
  return { ...before, parts: after };
}

/** Selects the plant that now overlaps most with the selected one. */
export function followSelection(clipSession: ClipSession) {
  const plantRef = clipSession.selected.value;
  const tracks = plantRef && clipSession.detection.value?.parts[plantRef.part];
  if (!plantRef || !tracks) {
    clipSession.selected.value = null;
    return;
  }
  const { side, part } = plantRef;
  const { intervals } = tracks[side];
  const track = { side, part, intervals, frames: clipSession.clip.value?.frames ?? 0 };
  clipSession.selected.value = matchingPlantRef(track, plantRef) ?? null;
}

/** Selects a plant, and optionally one of its edges; without a plant, selects nothing. */
export function select(plantRef: PlantRef | undefined, edge: "start" | "end" | null = null) {
  batch(() => {
    if (plantRef) addTarget.value = { side: plantRef.side, part: plantRef.part };
    selected.value = plantRef ?? null;
    selectedEdge.value = edge;
    selectedCut.value = null;
  });
}

/** Selects the next plant under the playhead: contact before heel and toe, left before right. */
export function selectAtPlayhead() {
  const parts = ["contact", "heel", "toe"] as const;
  const candidates = (["left", "right"] as const)
    .flatMap((side) => parts.map((part) => partTrackOf({ side, part })))
    .map((track) => track && plantRefAt(track, frame.value))
    .filter((plantRef) => plantRef !== undefined);
  const current = selected.value;
  const index = candidates.findIndex(
    ({ side, part, start }) =>
      side === current?.side && part === current.part && start === current.start,
  );
  const next = candidates[(index + 1) % candidates.length];
  if (next) selectAndAnnounce(next);
  else {
    select(undefined);
    announce("No foot is planted at the playhead");
  }
}

function selectAndAnnounce(plantRef: PlantRef) {
  select(plantRef);
  announce(`${plantRef.side} ${plantRef.part} selected, ${spokenRange(plantRef)}`);
}

/**
 * Goes to the next or previous plant edge, or to the end of the clip. A selection moves to the plant of that edge: of
 * the same part, and of the same foot if both feet have an edge there.
 */
export function stepEdge(direction: 1 | -1) {
  const { side = "left", part = principalPart(detection.value?.parts ?? {}) } =
    selected.value ?? {};
  const plantRefs = [side, otherSide[side]]
    .map((foot) => part && partTrackOf({ side: foot, part }))
    .flatMap((track) => (track ? plantRefsOf(track) : []));
  const edge = stepThrough(plantEdges(plantRefs), direction);
  const reached = plantRefs.find(({ start, end }) => start === edge || end - 1 === edge);
  if (selected.value && reached) selectAndAnnounce(reached);
}

const otherSide = { left: "right", right: "left" } as const;

/** Selects the next or previous plant of low confidence that is not edited. */
export function stepUncertain(direction: 1 | -1) {
  const part = principalPart(detection.value?.parts ?? {});
  const uncertain = plants.value.filter(
    ({ edited, confidence }) => !edited && confidence < minPlantConfidence,
  );
  const now = selection.value?.plant?.start ?? frame.value;
  const isSelected = selection.value?.plant !== undefined;
  const next =
    direction > 0
      ? (uncertain.find(({ start }) => start > now || (!isSelected && start === now)) ??
        uncertain[0])
      : (uncertain.findLast(({ start }) => start < now) ?? uncertain.at(-1));
  if (!part || !next) {
    notify("No plant has low confidence");
    return;
  }
  const { side, start, end } = next;
  pause();
  seek(start);
  select({ side, part, start, end });
  announce(
    `Plant ${next.number}, ${side} foot, ${spokenRange(next)}, ${Math.floor(100 * next.confidence)} percent`,
  );
}

/** Reports why there is no plant to edit. */
const reportNoPlant = (message = "Select a plant first") =>
  notify(detection.value ? message : "There are no labels yet");

/** Gives the selected plant another start or end. */
export const resizeSelected = (to: Partial<FrameRange>) => inOrder(() => resize(to));

async function resize(to: Partial<FrameRange>): Promise<void> {
  const current = selection.value;
  if (!current) {
    reportNoPlant();
    return;
  }
  const { plantRef, track } = current;
  const range = { start: to.start ?? plantRef.start, end: to.end ?? plantRef.end };
  if (range.start === plantRef.start && range.end === plantRef.end) return;
  if (range.start >= range.end) {
    notify("The end must be after the start");
    return;
  }
  const limited = { start: Math.max(range.start, 0), end: Math.min(range.end, track.frames) };
  const next = [...edits.value, ...resizePlant(track, plantRef, limited)];
  const joined = joinedCount(track, plantRef, limited);
  const details = joined ? `, joined with ${plural(joined, "plant")}` : "";
  await commitEdits(next, capitalize(spokenRange(limited)) + details, limited);
}

/** Returns the number of other plants that a new range overlaps or touches. */
function joinedCount({ intervals }: PartTrack, plant: PlantRef, { start, end }: FrameRange) {
  let count = 0;
  for (let i = 0; i < intervals.length; i += 2) {
    const [from = 0, to = 0] = [intervals[i], intervals[i + 1]];
    if (from !== plant.start && to >= start && from <= end) count++;
  }
  return count;
}

/** Makes the frame under the playhead the first or last one of the selected plant. */
export const startAtPlayhead = () => resizeSelected({ start: frame.value });
export const endAtPlayhead = () => resizeSelected({ end: frame.value + 1 });

/**
 * Moves an edge by a number of frames, and the playhead to it: the selected edge, else the edge of the
 * selected plant that is nearest to the playhead, else the nearest edge of all plants.
 */
export const nudgeEdge = (by: number) => inOrder(() => moveEdge(by));

/** Moves one edge of the selected plant by a number of frames, and the playhead to it. */
export function nudgeSelected(edge: "start" | "end", by: number): Promise<void> {
  selectedEdge.value = edge;
  return nudgeEdge(by);
}

async function moveEdge(by: number): Promise<void> {
  const plantRef = selection.value?.plantRef ?? nearestPlant();
  if (!plantRef) {
    reportNoPlant("There is no plant near the playhead");
    return;
  }
  const edge = selection.value && selectedEdge.value ? selectedEdge.value : nearestEdge(plantRef);
  select(plantRef, edge);
  const { frames = 0 } = selection.value?.track ?? {};
  const to = Math.min(Math.max(plantRef[edge] + by, 0), frames);
  pause();
  seek(edge === "start" ? to : to - 1);
  await resize({ [edge]: to });
  selectedEdge.value = edge;
}

/** Distances of the playhead from the first and the last frame of a plant. */
const distances = ({ start, end }: FrameRange) =>
  [Math.abs(frame.value - start), Math.abs(frame.value - (end - 1))] as const;

function nearestEdge(range: FrameRange): "start" | "end" {
  const [toStart, toEnd] = distances(range);
  return toStart < toEnd ? "start" : "end";
}

/** Returns the plant of the principal part with the edge nearest to the playhead. */
function nearestPlant(): PlantRef | undefined {
  const part = principalPart(detection.value?.parts ?? {});
  const distance = (plant: FrameRange) => Math.min(...distances(plant));
  const [first, ...others] = plants.value;
  if (!part || !first) return undefined;
  const { side, start, end } = others.reduce((a, b) => (distance(b) < distance(a) ? b : a), first);
  return { side, part, start, end };
}

/** Splits the selected plant by a gap of one frame at the playhead. */
export function splitAtPlayhead(): Promise<void> {
  const at = frame.value;
  return change(
    ({ plantRef }) => append(splitPlant(plantRef, at)),
    "Plant split: this frame is not planted",
    "Move the playhead into the plant to split it",
  );
}

export function joinNext(): Promise<void> {
  return change(
    ({ track, plantRef }) => {
      const joined = joinWithNext(plantEdits.value, track, plantRef);
      return joined && [...joined, ...cutEditsOf(edits.value)];
    },
    "Joined with the next plant",
    "There is no next plant to join with",
  );
}

export const removeSelected = () =>
  change(({ plantRef }) => append(removePlant(plantRef)), "Plant deleted", "");

/** Returns the edits with others at the end; undefined if there are no others. */
const append = (added: readonly AnyEdit[]) =>
  added.length ? [...edits.value, ...added] : undefined;

function change(
  edit: (selected: { track: PartTrack; plantRef: PlantRef }) => readonly AnyEdit[] | undefined,
  success: string,
  failure: string,
): Promise<void> {
  return inOrder(async () => {
    const current = selection.value;
    const next = current && edit(current);
    if (next) await commitEdits(next, success);
    else if (current) notify(failure);
    else reportNoPlant();
  });
}

/** Reverts the selected plant to what was detected. */
export const revertSelected = () =>
  inOrder(async () => {
    const plantRef = selected.value;
    if (!plantRef) return;
    const others = withoutEditsOf(plantEdits.value, plantRef);
    await commitEdits([...others, ...cutEditsOf(edits.value)], "Plant reverted");
  });

/** Reverts all labels to what was detected. */
export const revertAll = () =>
  inOrder(async () => {
    if (plantEdits.value.length) await commitEdits(cutEditsOf(edits.value), "All plants reverted");
  });

/** Adds a plant that starts at the playhead. */
export function addAtPlayhead(side: Side, part: Part): Promise<void> {
  const at = frame.value;
  return inOrder(async () => {
    const track = partTrackOf({ side, part });
    if (!track) return;
    const added = addPlant(track, at, addedDuration * (clip.value?.rate ?? 1));
    const [first] = added;
    if (!first) {
      notify(`The ${side} foot is already planted at the playhead`);
      return;
    }
    select({ side, part, start: first.start, end: first.end });
    await commitEdits(
      [...edits.value, ...added],
      `${capitalize(side)} ${part} added, ${spokenRange(first)}`,
    );
  });
}

/** Adds a plant at the playhead on the track that was used last. */
export async function addToTarget(): Promise<void> {
  const target = targetTrack.value;
  if (target) await addAtPlayhead(target.side, target.part);
  else reportNoPlant();
}

/** Replaces the edits by those that give the labels of the reference. */
export const adoptReference = () =>
  inOrder(async () => {
    const clipSession = session.value;
    try {
      const reference = await clipSession.run("reference edits", () => engine.referenceEdits());
      if (reference?.length)
        await commitEdits(
          [...reference, ...cutEditsOf(clipSession.edits.value)],
          "Labels replaced by those of the reference",
        );
    } catch (error) {
      reportFailure("edited", clipSession.source?.name ?? "", error, () => void adoptReference());
    }
  });

/** Shows the start and end fields of a plant. */
export function editEdges(plantRef: PlantRef) {
  batch(() => {
    pause();
    select(plantRef);
    seek(plantRef.start);
    showTab("labels");
  });
}
