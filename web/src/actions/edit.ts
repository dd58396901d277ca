/** Editing plants by hand. Each command appends to the list of edits, and can be undone. */

import { batch, computed, type Signal } from "@preact/signals";
import { engine } from "../engine";
import {
  addPlant,
  type FrameRange,
  matchingPlantRef,
  mergeWithNext,
  type PartTrack,
  type PlantRef,
  plantRefAt,
  removePlant,
  resizePlant,
  splitPlant,
  withoutEditsOf,
} from "../model/edits";
import { instantsOf, principalPart } from "../model/plants";
import type { Detection, Edit, EditedParts, Part, Side, Track } from "../model/types";
import { type ClipSession, session } from "../store/clip-session";
import { reportFailure } from "../store/errors";
import { frame } from "../store/playback";
import { clip, detection, edits, plants, selected } from "../store/session";
import { activeTab, announcement, sheetOpen } from "../store/view";
import { updateScores } from "./compare";
import { pause, seek } from "./playback";

/** Initial duration of an added plant, in seconds. */
const addedDuration = 0.25;

export const canUndo = computed(() => session.value.undoStack.value.length > 0);
export const canRedo = computed(() => session.value.redoStack.value.length > 0);

/** The side that was selected last. */
let lastSide: Side = "left";

/** Returns the track of a part of a foot, if it is labelled. */
function partTrackOf({ side, part }: { side: Side; part: Part }): PartTrack | undefined {
  const tracks = detection.value?.parts[part];
  const frames = clip.value?.frames ?? 0;
  return tracks && { side, part, intervals: tracks[side].intervals, frames };
}

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

/** Replaces the edits, also those to which undo and redo return. */
export async function replaceEdits(
  clipSession: ClipSession,
  replace: (edits: readonly Edit[]) => readonly Edit[],
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

/** Replaces the edits; this can be undone. */
export function commitEdits(
  next: readonly Edit[],
  message: string,
  range?: FrameRange,
): Promise<void> {
  const clipSession = session.value;
  batch(() => {
    clipSession.undoStack.value = [...clipSession.undoStack.value, clipSession.edits.value];
    clipSession.redoStack.value = [];
    clipSession.edits.value = next;
    if (range && clipSession.selected.value)
      clipSession.selected.value = { ...clipSession.selected.value, ...range };
    announcement.value = message;
  });
  return applyEdits(clipSession);
}

export const undo = () => swap(session.value.undoStack, session.value.redoStack, "Undone");
export const redo = () => swap(session.value.redoStack, session.value.undoStack, "Redone");

type EditStack = Signal<readonly (readonly Edit[])[]>;

function swap(from: EditStack, to: EditStack, message: string) {
  const clipSession = session.value;
  const next = from.value.at(-1);
  if (!next) return;
  batch(() => {
    from.value = from.value.slice(0, -1);
    to.value = [...to.value, clipSession.edits.value];
    clipSession.edits.value = next;
    announcement.value = message;
  });
  void applyEdits(clipSession);
}

/** Applies the edits to the labels. */
async function applyEdits(clipSession: ClipSession): Promise<void> {
  try {
    const parts = await clipSession.run("edit", () => engine.edit([...clipSession.edits.value]));
    if (!parts) return;
    batch(() => {
      const before = clipSession.detection.value;
      if (before) clipSession.detection.value = withParts(before, parts);
      followSelection(clipSession);
    });
    await updateScores(clipSession);
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

export function select(plantRef: PlantRef | undefined) {
  if (plantRef) lastSide = plantRef.side;
  selected.value = plantRef ?? null;
}

/** Selects the next plant under the playhead: contact before heel and toe, left before right. */
export function selectAtPlayhead() {
  const parts = ["contact", "heel", "toe"] as const;
  const candidates = (["left", "right"] as const)
    .flatMap((side) => parts.map((part) => partTrackOf({ side, part })))
    .map((track) => track && plantRefAt(track, frame.value))
    .filter((plantRef) => plantRef !== undefined);
  const index = candidates.findIndex(
    ({ side, part }) => side === selected.value?.side && part === selected.value.part,
  );
  const next = candidates[(index + 1) % candidates.length];
  select(next);
  announcement.value = next
    ? `${next.side} ${next.part} selected, frames ${next.start} to ${next.end}`
    : "No foot is planted at the playhead";
}

/** Gives the selected plant another start or end. */
export function resizeSelected(to: Partial<FrameRange>): Promise<void> | undefined {
  const current = selection.value;
  if (!current) return undefined;
  const { plantRef, track } = current;
  const range = { start: to.start ?? plantRef.start, end: to.end ?? plantRef.end };
  if (range.start === plantRef.start && range.end === plantRef.end) return undefined;
  if (range.start >= range.end) {
    announcement.value = "The end must be after the start";
    return undefined;
  }
  const next = [...edits.value, ...resizePlant(track, plantRef, range)];
  return commitEdits(next, `Frames ${range.start} to ${range.end}`, range);
}

/** Makes the frame under the playhead the first or last one of the selected plant. */
export const startAtPlayhead = () => resizeSelected({ start: frame.value });
export const endAtPlayhead = () => resizeSelected({ end: frame.value + 1 });

export function splitAtPlayhead() {
  change(
    ({ track, plantRef }) => splitPlant(track, plantRef, frame.value),
    "Split",
    "Move the playhead into the plant to split it",
  );
}

export function mergeNext() {
  change(
    ({ track, plantRef }) => mergeWithNext(track, plantRef),
    "Merged with the next plant",
    "There is no next plant to merge with",
  );
}

export function removeSelected() {
  change(({ plantRef }) => removePlant(plantRef), "Deleted", "");
}

function change(
  edit: (selected: { track: PartTrack; plantRef: PlantRef }) => Edit[],
  success: string,
  failure: string,
) {
  const current = selection.value;
  const added = current ? edit(current) : [];
  if (added.length) void commitEdits([...edits.value, ...added], success);
  else announcement.value = current ? failure : "Select a plant first";
}

/** Reverts the selected plant to what was detected. */
export function revertSelected() {
  const plantRef = selected.value;
  if (plantRef) void commitEdits(withoutEditsOf(edits.value, plantRef), "Plant reverted");
}

/** Reverts all labels to what was detected. */
export function revertAll() {
  if (edits.value.length) void commitEdits([], "All plants reverted");
}

/** Adds a plant that starts at the playhead. */
export function addAtPlayhead(side: Side, part: Part) {
  const track = partTrackOf({ side, part });
  if (!track) return;
  const added = addPlant(track, frame.value, addedDuration * (clip.value?.rate ?? 1));
  const [first] = added;
  if (!first) {
    announcement.value = `The ${side} foot is already planted at the playhead`;
    return;
  }
  select({ side, part, start: first.start, end: first.end });
  void commitEdits(
    [...edits.value, ...added],
    `${side} ${part} added, frames ${first.start} to ${first.end}`,
  );
}

/** Adds a plant of the side that was selected last. */
export function addForLastSide() {
  const part = principalPart(detection.value?.parts ?? {});
  if (part) addAtPlayhead(lastSide, selected.value?.part ?? part);
}

/** Replaces the edits by those that give the labels of the reference. */
export async function adoptReference(): Promise<void> {
  const clipSession = session.value;
  const reference = await clipSession.run("reference edits", () => engine.referenceEdits());
  if (reference?.length) await commitEdits(reference, "Labels replaced by those of the reference");
}

/** Shows the start and end fields of a plant. */
export function editEdges(plantRef: PlantRef) {
  batch(() => {
    pause();
    select(plantRef);
    seek(plantRef.start);
    activeTab.value = "labels";
    sheetOpen.value = true;
  });
}
