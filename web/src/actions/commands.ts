/**
 * The commands of the page. Key handler, key overlay, buttons and tooltips are made from this
 * list, so that a key or a label is written once.
 */

import type { NamedSegment } from "../model/segments/segments";
import { batchRows, finishedCount, savesTable, tableVisible } from "../store/batch";
import { isHosted } from "../store/embedded";
import { classicKeys, panelCollapsed } from "../store/preferences";
import { openClip, selected, selectedCut, similar } from "../store/session";
import { endTour, tourStep } from "../store/tour";
import { dialog, frameAllRequests, lookAtFeet, lookFrom, trailsVisible } from "../store/view";
import { reviewNext, rowToMark, toggleChecked } from "./analyse/batch";
import { stepDisagreement } from "./analyse/compare";
import { editSegmentName } from "./analyse/segment";
import {
  addToTarget,
  canRedo,
  canUndo,
  endAtPlayhead,
  joinNext,
  nudgeEdge,
  redo,
  removeSelected,
  select,
  selectAtPlayhead,
  splitAtPlayhead,
  startAtPlayhead,
  stepEdge,
  stepUncertain,
  undo,
} from "./edit/edit";
import { addCutAtPlayhead, nudgeCut, removeNearestCut } from "./edit/edit-cuts";
import { applySimilar, dismissSimilar } from "./edit/similar";
import { bindingIndex, type KeyBinding, keyText } from "./key-bindings";
import { pickFiles, pickVideo } from "./open/pick-files";
import { exportLabels } from "./save/export";
import {
  changeSpeed,
  cycleLoop,
  fitTimeline,
  jumpTo,
  jumpToEnd,
  loopSegment,
  pause,
  segmentAtPlayhead,
  setLoopEdge,
  shuttle,
  stepCut,
  stepFrame,
  togglePlay,
  zoomTimeline,
} from "./view/playback";

export const groups = ["Play", "Segments", "Edit", "View", "File"] as const;

export interface Command {
  id: string;
  group: (typeof groups)[number];
  /** Name in buttons and tooltips. */
  label: string;
  /** Description in the key overlay. Neighbours with the same text share a row. */
  help: string;
  /** Key bindings; the first one is displayed. */
  keys: readonly KeyBinding[];
  /** Key bindings if the user chose the classic keys; by default, the same. */
  classic?: readonly KeyBinding[];
  /** True if the command can run. Default: if a clip is open. */
  enabled?: () => boolean;
  /** True if the key also works in dialogs and text fields. */
  isGlobal?: boolean;
  run: () => unknown;
}

/** True if a clip is open and not covered by the table. */
const hasClip = () => openClip.value !== null && !tableVisible.value;

/** True if the table is shown and no dialog, which may be about the open clip. */
const isTableInFront = () => tableVisible.value && dialog.value === null;

const zoomFactor = 0.7;

/** Moves the selected cut, or else an edge, by a number of frames. */
const nudge = (by: number) => (selectedCut.value === null ? nudgeEdge(by) : nudgeCut(by));

function withSegment(segment: NamedSegment | undefined, run: (segment: NamedSegment) => void) {
  if (segment) run(segment);
}

const list = [
  {
    id: "play",
    group: "Play",
    label: "Play",
    help: "Play or pause",
    keys: [{ key: " " }],
    run: togglePlay,
  },
  {
    id: "shuttle-back",
    group: "Play",
    label: "Play backwards",
    help: "Play backwards, pause, forwards; again for faster",
    keys: [{ key: "j" }],
    classic: [],
    run: () => shuttle(-1),
  },
  {
    id: "pause",
    group: "Play",
    label: "Pause",
    help: "Play backwards, pause, forwards; again for faster",
    keys: [{ key: "k" }],
    classic: [],
    run: pause,
  },
  {
    id: "shuttle-ahead",
    group: "Play",
    label: "Play forwards",
    help: "Play backwards, pause, forwards; again for faster",
    keys: [{ key: "l" }],
    classic: [],
    run: () => shuttle(1),
  },
  {
    id: "frame-back",
    group: "Play",
    label: "Previous frame",
    help: "Previous, next frame",
    keys: [{ key: "arrowleft" }, { key: "," }],
    classic: [{ key: "arrowleft" }],
    run: () => stepFrame(-1),
  },
  {
    id: "frame-ahead",
    group: "Play",
    label: "Next frame",
    help: "Previous, next frame",
    keys: [{ key: "arrowright" }, { key: "." }],
    classic: [{ key: "arrowright" }],
    run: () => stepFrame(1),
  },
  {
    id: "previous-edge",
    group: "Play",
    label: "Previous plant edge",
    help: "Previous, next plant edge",
    keys: [{ key: "arrowleft", shift: true }],
    run: () => stepEdge(-1),
  },
  {
    id: "next-edge",
    group: "Play",
    label: "Next plant edge",
    help: "Previous, next plant edge",
    keys: [{ key: "arrowright", shift: true }],
    run: () => stepEdge(1),
  },
  {
    id: "next-uncertain",
    group: "Play",
    label: "Next plant to review",
    help: "Next plant of low confidence",
    keys: [{ key: "u" }],
    run: () => stepUncertain(1),
  },
  {
    id: "previous-uncertain",
    group: "Play",
    label: "Previous plant to review",
    help: "Previous plant of low confidence",
    keys: [{ key: "u", shift: true }],
    run: () => stepUncertain(-1),
  },
  {
    id: "next-difference",
    group: "Play",
    label: "Next difference",
    help: "Next difference from the reference",
    keys: [{ key: "d" }],
    run: () => stepDisagreement(1),
  },
  {
    id: "previous-difference",
    group: "Play",
    label: "Previous difference",
    help: "Previous difference from the reference",
    keys: [{ key: "d", shift: true }],
    run: () => stepDisagreement(-1),
  },
  {
    id: "first-frame",
    group: "Play",
    label: "First frame",
    help: "First, last frame",
    keys: [{ key: "home" }],
    run: () => jumpTo(0),
  },
  {
    id: "last-frame",
    group: "Play",
    label: "Last frame",
    help: "First, last frame",
    keys: [{ key: "end" }],
    run: jumpToEnd,
  },
  {
    id: "slower",
    group: "Play",
    label: "Slower",
    help: "Slower, faster",
    keys: [{ key: "<" }],
    classic: [{ key: "," }],
    run: () => changeSpeed(-1),
  },
  {
    id: "faster",
    group: "Play",
    label: "Faster",
    help: "Slower, faster",
    keys: [{ key: ">" }],
    classic: [{ key: "." }],
    run: () => changeSpeed(1),
  },
  {
    id: "loop",
    group: "Play",
    label: "Loop: clip, plant, segment, off",
    help: "Loop: clip, plant, segment, off",
    keys: [{ key: "l", shift: true }],
    classic: [{ key: "l" }],
    run: cycleLoop,
  },
  {
    id: "loop-start",
    group: "Play",
    label: "Start of the loop",
    help: "First, last frame of a looped range",
    keys: [{ key: "i", shift: true }],
    run: () => setLoopEdge("start"),
  },
  {
    id: "loop-end",
    group: "Play",
    label: "End of the loop",
    help: "First, last frame of a looped range",
    keys: [{ key: "o", shift: true }],
    run: () => setLoopEdge("end"),
  },
  {
    id: "previous-cut",
    group: "Segments",
    label: "Previous cut",
    help: "Previous, next cut",
    keys: [{ key: "[" }],
    run: () => stepCut(-1),
  },
  {
    id: "next-cut",
    group: "Segments",
    label: "Next cut",
    help: "Previous, next cut",
    keys: [{ key: "]" }],
    run: () => stepCut(1),
  },
  {
    id: "loop-segment",
    group: "Segments",
    label: "Loop segment",
    help: "Loop the segment at the playhead",
    keys: [{ key: "s" }],
    run: () => withSegment(segmentAtPlayhead(), loopSegment),
  },
  {
    id: "name-segment",
    group: "Segments",
    label: "Name segment",
    help: "Name the segment at the playhead",
    keys: [{ key: "enter" }],
    run: () => withSegment(segmentAtPlayhead(), editSegmentName),
  },
  {
    id: "add-cut",
    group: "Segments",
    label: "Add cut",
    help: "Add a cut at the playhead",
    keys: [{ key: "x" }],
    run: addCutAtPlayhead,
  },
  {
    id: "remove-cut",
    group: "Segments",
    label: "Remove cut",
    help: "Remove the selected or the nearest cut",
    keys: [{ key: "x", shift: true }],
    run: removeNearestCut,
  },
  {
    id: "select",
    group: "Edit",
    label: "Select plant",
    help: "Select the plant at the playhead; again for the next one",
    keys: [{ key: "e" }],
    run: selectAtPlayhead,
  },
  {
    id: "set-start",
    group: "Edit",
    label: "Set start",
    help: "Set the first, last frame of the plant to the playhead",
    keys: [{ key: "i" }],
    run: startAtPlayhead,
  },
  {
    id: "set-end",
    group: "Edit",
    label: "Set end",
    help: "Set the first, last frame of the plant to the playhead",
    keys: [{ key: "o" }],
    run: endAtPlayhead,
  },
  {
    id: "nudge-back",
    group: "Edit",
    label: "Edge one frame earlier",
    help: "Move the edge or the cut by a frame; with Shift by five",
    keys: [{ key: "q" }],
    run: () => nudge(-1),
  },
  {
    id: "nudge-ahead",
    group: "Edit",
    label: "Edge one frame later",
    help: "Move the edge or the cut by a frame; with Shift by five",
    keys: [{ key: "w" }],
    run: () => nudge(1),
  },
  {
    id: "nudge-back-far",
    group: "Edit",
    label: "Edge five frames earlier",
    help: "Move the edge or the cut by a frame; with Shift by five",
    keys: [{ key: "q", shift: true }],
    run: () => nudge(-5),
  },
  {
    id: "nudge-ahead-far",
    group: "Edit",
    label: "Edge five frames later",
    help: "Move the edge or the cut by a frame; with Shift by five",
    keys: [{ key: "w", shift: true }],
    run: () => nudge(5),
  },
  {
    id: "split",
    group: "Edit",
    label: "Split at playhead",
    help: "Split the plant by a gap of one frame",
    keys: [{ key: "b" }],
    classic: [{ key: "k" }],
    run: splitAtPlayhead,
  },
  {
    id: "join",
    group: "Edit",
    label: "Join with next",
    help: "Join the plant with the next one",
    keys: [{ key: "m" }],
    run: joinNext,
  },
  {
    id: "add",
    group: "Edit",
    label: "Add a plant at the playhead",
    help: "Add a plant at the playhead, on the track used last",
    keys: [{ key: "a" }],
    run: addToTarget,
  },
  {
    id: "delete",
    group: "Edit",
    label: "Delete",
    help: "Delete the plant or the cut",
    keys: [{ key: "delete" }, { key: "backspace" }],
    run: () => (selectedCut.value === null ? removeSelected() : removeNearestCut()),
  },
  {
    id: "apply-similar",
    group: "Edit",
    label: "Apply to similar plants",
    help: "Apply the edits to similar plants",
    keys: [{ key: "y" }],
    enabled: () => hasClip() && similar.value !== null,
    run: applySimilar,
  },
  {
    id: "dismiss-similar",
    group: "Edit",
    label: "Leave similar plants as they are",
    help: "Leave similar plants as they are",
    keys: [{ key: "y", shift: true }],
    enabled: () => hasClip() && similar.value !== null,
    run: dismissSimilar,
  },
  {
    id: "undo",
    group: "Edit",
    label: "Undo",
    help: "Undo",
    keys: [{ key: "z", mod: true }],
    enabled: () => hasClip() && canUndo.value,
    run: undo,
  },
  {
    id: "redo",
    group: "Edit",
    label: "Redo",
    help: "Redo",
    keys: [
      { key: "z", mod: true, shift: true },
      { key: "y", mod: true },
    ],
    enabled: () => hasClip() && canRedo.value,
    run: redo,
  },
  {
    id: "escape",
    group: "Edit",
    label: "Deselect",
    help: "End the tour, or deselect",
    keys: [{ key: "escape" }],
    enabled: () =>
      hasClip() &&
      (tourStep.value !== null || selected.value !== null || selectedCut.value !== null),
    run: () => (tourStep.value === null ? select(undefined) : endTour()),
  },
  {
    id: "view-perspective",
    group: "View",
    label: "Perspective",
    help: "Perspective, front, side, top",
    keys: [{ key: "1" }],
    run: () => lookFrom("perspective"),
  },
  {
    id: "view-front",
    group: "View",
    label: "Front",
    help: "Perspective, front, side, top",
    keys: [{ key: "2" }],
    run: () => lookFrom("front"),
  },
  {
    id: "view-side",
    group: "View",
    label: "Side",
    help: "Perspective, front, side, top",
    keys: [{ key: "3" }],
    run: () => lookFrom("side"),
  },
  {
    id: "view-top",
    group: "View",
    label: "Top",
    help: "Perspective, front, side, top",
    keys: [{ key: "4" }],
    run: () => lookFrom("top"),
  },
  {
    id: "view-feet",
    group: "View",
    label: "Feet",
    help: "Close-up of the feet",
    keys: [{ key: "5" }],
    run: lookAtFeet,
  },
  {
    id: "frame-all",
    group: "View",
    label: "Frame all",
    help: "Frame all",
    keys: [{ key: "f" }],
    run: () => frameAllRequests.value++,
  },
  {
    id: "trails",
    group: "View",
    label: "Trails of toes and hips, ± 1 s",
    help: "Trails of toes and hips",
    keys: [{ key: "t" }],
    run: () => {
      trailsVisible.value = !trailsVisible.value;
    },
  },
  {
    id: "video",
    group: "View",
    label: "Video next to the view",
    help: "Choose a video to show next to the view",
    keys: [{ key: "v" }],
    enabled: () => hasClip() && Boolean(openClip.value?.frames),
    run: pickVideo,
  },
  {
    id: "panel",
    group: "View",
    label: "Show or hide the panel",
    help: "Show or hide the panel",
    keys: [{ key: "p" }],
    run: () => panelCollapsed.set(!panelCollapsed.peek()),
  },
  {
    id: "zoom-in",
    group: "View",
    label: "Zoom in",
    help: "Zoom the timeline",
    keys: [{ key: "+" }, { key: "=" }],
    run: () => zoomTimeline(zoomFactor),
  },
  {
    id: "zoom-out",
    group: "View",
    label: "Zoom out",
    help: "Zoom the timeline",
    keys: [{ key: "-" }],
    run: () => zoomTimeline(1 / zoomFactor),
  },
  {
    id: "fit",
    group: "View",
    label: "Show the entire clip",
    help: "Fit the timeline",
    keys: [{ key: "0" }],
    run: fitTimeline,
  },
  {
    id: "review-next",
    group: "File",
    label: "Next clip to review",
    help: "Open the least certain clip that is not checked",
    keys: [{ key: "n" }],
    enabled: () => batchRows.value.length > 0,
    run: reviewNext,
  },
  {
    id: "mark-checked",
    group: "File",
    label: "Checked",
    help: "Mark the clip as checked",
    keys: [{ key: "c" }],
    enabled: () => rowToMark.value !== undefined,
    run: () => toggleChecked(),
  },
  {
    id: "open",
    group: "File",
    label: "Open",
    help: "Open",
    keys: [{ key: "o", mod: true }],
    enabled: () => !isHosted,
    isGlobal: true,
    run: pickFiles,
  },
  {
    id: "save",
    group: "File",
    label: "Save labels as JSON",
    help: "Save labels as JSON, or all clips of the table",
    keys: [{ key: "s", mod: true }],
    enabled: () => (isTableInFront() ? finishedCount.value > 0 : openClip.value !== null),
    isGlobal: true,
    run: () => {
      if (isTableInFront()) savesTable.value = true;
      else void exportLabels();
    },
  },
  {
    id: "keys",
    group: "File",
    label: "Keyboard shortcuts",
    help: "Keyboard shortcuts",
    keys: [{ key: "?" }],
    enabled: () => true,
    run: () => {
      dialog.value = "keys";
    },
  },
] as const satisfies readonly Command[];

export type CommandId = (typeof list)[number]["id"];

export const commands: readonly Command[] = list;

const byId = new Map<string, Command>(commands.map((command) => [command.id, command]));

/** Returns the command with that id. */
export function commandOf(id: CommandId): Command {
  return byId.get(id) as Command;
}

export const isEnabled = ({ enabled = hasClip }: Command) => enabled();

/** Returns the key bindings of a command in the chosen key map. */
export const keysOf = ({ keys, classic }: Command) => (classicKeys.value && classic) || keys;

/** Returns the command bound to a key press, whether or not it is enabled. */
export function commandForKey(event: Pick<KeyboardEvent, "key" | "shiftKey">, mod: boolean) {
  return commands[bindingIndex(commands.map(keysOf), event, mod)];
}

/** Returns the display text of the first key of a command; empty if it has none. */
export function keyOf(id: CommandId): string {
  const [key] = keysOf(commandOf(id));
  return key ? keyText(key) : "";
}

/** Returns the tooltip of a button: its label and its key. */
export function tooltip(id: CommandId, label = commandOf(id).label): string {
  const key = keyOf(id);
  return key ? `${label} (${key})` : label;
}

/** Returns the rows of the key overlay by group: keys, and what they do. */
export const keyTable = () =>
  groups.map((group) => {
    const rows = new Map<string, string[]>();
    for (const command of commands.filter((other) => other.group === group)) {
      const words = keysOf(command)
        .slice(0, 1)
        .flatMap((key) => keyText(key).split(" "));
      if (words.length)
        rows.set(command.help, [...new Set([...(rows.get(command.help) ?? []), ...words])]);
    }
    return { group, rows: [...rows].map(([help, keys]) => ({ help, keys })) };
  });
