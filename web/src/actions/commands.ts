/**
 * The commands of the page. Key handler, key overlay, buttons and tooltips are made from this
 * list, so that a key or a label is written once.
 */

import type { NamedSegment } from "../model/segments";
import { loopedSegment } from "../store/playback";
import { openClip, selected } from "../store/session";
import { dialog, frameAllRequests, lookFrom, trailsVisible } from "../store/view";
import { stepDisagreement } from "./compare";
import {
  addForLastSide,
  canRedo,
  canUndo,
  endAtPlayhead,
  mergeNext,
  redo,
  removeSelected,
  select,
  selectAtPlayhead,
  splitAtPlayhead,
  startAtPlayhead,
  undo,
} from "./edit";
import { exportLabels } from "./export";
import { pickFiles } from "./pick-files";
import {
  changeSpeed,
  cycleLoop,
  fitTimeline,
  jumpTo,
  jumpToEnd,
  loopSegment,
  segmentAtPlayhead,
  stepCut,
  stepEdge,
  stepFrame,
  togglePlay,
  zoomTimeline,
} from "./playback";
import { editSegmentName } from "./segment";

/** A key as in `KeyboardEvent.key`, lower case, with the modifiers that it requires. */
export interface KeyBinding {
  key: string;
  /** True if Ctrl or ⌘ is required. */
  mod?: boolean;
  shift?: boolean;
}

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
  /** True if the command can run. Default: if a clip is open. */
  enabled?: () => boolean;
  /** True if the key also works in dialogs and text fields. */
  isGlobal?: boolean;
  run: () => unknown;
}

const hasClip = () => openClip.value !== null;
const zoomFactor = 0.7;

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
    id: "frame-back",
    group: "Play",
    label: "Previous frame",
    help: "Previous, next frame",
    keys: [{ key: "arrowleft" }],
    run: () => stepFrame(-1),
  },
  {
    id: "frame-ahead",
    group: "Play",
    label: "Next frame",
    help: "Previous, next frame",
    keys: [{ key: "arrowright" }],
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
    id: "next-difference",
    group: "Play",
    label: "Next difference",
    help: "Next difference from the reference",
    keys: [{ key: "n" }],
    run: () => stepDisagreement(1),
  },
  {
    id: "previous-difference",
    group: "Play",
    label: "Previous difference",
    help: "Previous difference",
    keys: [{ key: "n", shift: true }],
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
    keys: [{ key: "," }],
    run: () => changeSpeed(-1),
  },
  {
    id: "faster",
    group: "Play",
    label: "Faster",
    help: "Slower, faster",
    keys: [{ key: "." }],
    run: () => changeSpeed(1),
  },
  {
    id: "loop",
    group: "Play",
    label: "Loop: clip, plant, segment, off",
    help: "Loop: clip, plant, segment, off",
    keys: [{ key: "l" }],
    run: cycleLoop,
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
    help: "Name the looped segment, or the one at the playhead",
    keys: [{ key: "enter" }],
    run: () => withSegment(loopedSegment.value ?? segmentAtPlayhead(), editSegmentName),
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
    label: "Set start to the playhead",
    help: "Move start, end of the plant to the playhead",
    keys: [{ key: "i" }],
    run: startAtPlayhead,
  },
  {
    id: "set-end",
    group: "Edit",
    label: "Set end to the playhead",
    help: "Move start, end of the plant to the playhead",
    keys: [{ key: "o" }],
    run: endAtPlayhead,
  },
  {
    id: "split",
    group: "Edit",
    label: "Split at playhead",
    help: "Split the plant at the playhead",
    keys: [{ key: "k" }],
    run: splitAtPlayhead,
  },
  {
    id: "merge",
    group: "Edit",
    label: "Merge with next",
    help: "Merge the plant with the next one",
    keys: [{ key: "m" }],
    run: mergeNext,
  },
  {
    id: "add",
    group: "Edit",
    label: "Add a plant at the playhead",
    help: "Add a plant at the playhead, for the side selected last",
    keys: [{ key: "a" }],
    run: addForLastSide,
  },
  {
    id: "delete",
    group: "Edit",
    label: "Delete",
    help: "Delete the plant",
    keys: [{ key: "delete" }, { key: "backspace" }],
    run: removeSelected,
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
    id: "deselect",
    group: "Edit",
    label: "Deselect",
    help: "Deselect",
    keys: [{ key: "escape" }],
    enabled: () => hasClip() && selected.value !== null,
    run: () => select(undefined),
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
    id: "frame-all",
    group: "View",
    label: "Frame everything",
    help: "Frame everything",
    keys: [{ key: "f" }],
    run: () => frameAllRequests.value++,
  },
  {
    id: "paths",
    group: "View",
    label: "Paths of toes and hips, ± 1 s",
    help: "Paths of toes and hips",
    keys: [{ key: "t" }],
    run: () => {
      trailsVisible.value = !trailsVisible.value;
    },
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
    id: "open",
    group: "File",
    label: "Open",
    help: "Open",
    keys: [{ key: "o", mod: true }],
    enabled: () => true,
    isGlobal: true,
    run: pickFiles,
  },
  {
    id: "save",
    group: "File",
    label: "Save labels as JSON",
    help: "Save labels as JSON",
    keys: [{ key: "s", mod: true }],
    isGlobal: true,
    run: () => exportLabels(),
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

/** Returns the command bound to a key press, whether or not it is enabled. */
export function commandForKey(event: Pick<KeyboardEvent, "key" | "shiftKey">, mod: boolean) {
  const key = event.key.toLowerCase();
  const matches = (shift: boolean) =>
    commands.find(({ keys }) =>
      keys.some(
        (binding) => binding.key === key && !!binding.mod === mod && !!binding.shift === shift,
      ),
    );
  // Some characters are typed with Shift, so Shift is compared only if a binding requires it.
  return matches(event.shiftKey) ?? (mod ? undefined : matches(false));
}

const keyNames: Record<string, string> = {
  " ": "Space",
  arrowleft: "←",
  arrowright: "→",
  escape: "Esc",
  "-": "−",
};

/** Returns the display text of a key: `Ctrl Shift Z`. */
export function keyText({ key, mod, shift }: KeyBinding): string {
  const name = keyNames[key] ?? key.charAt(0).toUpperCase() + key.slice(1);
  return [mod && "Ctrl", shift && "Shift", name].filter(Boolean).join(" ");
}

/** Returns the display text of the first key of a command. */
export function keyOf(id: CommandId): string {
  const [key] = commandOf(id).keys;
  return key ? keyText(key) : "";
}

/** Returns the tooltip of a button: its label and its key. */
export function tooltip(id: CommandId, label = commandOf(id).label): string {
  return `${label} (${keyOf(id)})`;
}

/** Rows of the key overlay by group: keys, and what they do. */
export const keyTable = groups.map((group) => {
  const rows = new Map<string, string[]>();
  for (const { help, keys } of commands.filter((command) => command.group === group)) {
    const words = keys.slice(0, 1).flatMap((key) => keyText(key).split(" "));
    rows.set(help, [...new Set([...(rows.get(help) ?? []), ...words])]);
  }
  return { group, rows: [...rows].map(([help, keys]) => ({ help, keys })) };
});
