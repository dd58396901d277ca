import type { Action } from "../lib/segments";
import { stepDisagreement } from "./compare";
import {
  addAgain,
  endHere,
  mergeNext,
  redo,
  remove,
  select,
  selectHere,
  splitHere,
  startHere,
  undo,
} from "./edit";
import {
  changeSpeed,
  cycleLoop,
  fitTimeline,
  loopSegment,
  pause,
  seek,
  segmentHere,
  step,
  stepCut,
  stepEdge,
  togglePlay,
  zoomTimeline,
} from "./playback";
import { save } from "./save";
import { askForName } from "./segment";
import {
  type CameraView,
  chosen,
  clip,
  dialog,
  frameAllRequests,
  look,
  openClip,
  trails,
} from "./state";

/** Every key of the page, in the words of the dialog that lists them. */
export const keyTable: readonly (readonly [
  group: string,
  rows: readonly (readonly [string, string])[],
])[] = [
  [
    "Play",
    [
      ["Space", "Play or pause"],
      ["← →", "One frame back, ahead"],
      ["Shift ← →", "Previous, next plant edge"],
      ["N", "Next difference; with Shift the one before"],
      ["Home End", "First, last frame"],
      [", .", "Slower, faster"],
      ["L", "Loop: clip, plant, segment, off"],
    ],
  ],
  [
    "Segments",
    [
      ["[ ]", "Previous, next cut"],
      ["S", "Loop the segment here"],
      ["Enter", "Name the segment looped, or here"],
    ],
  ],
  [
    "Edit",
    [
      ["E", "Select the plant here; again for the next one here"],
      ["I O", "It starts, ends here"],
      ["K", "Split it here"],
      ["M", "Merge it with the next one"],
      ["A", "Add a plant here, of the foot selected last"],
      ["Delete", "Delete it"],
      ["Ctrl Z", "Undo; with Shift redo"],
      ["Esc", "Select nothing"],
    ],
  ],
  [
    "Look",
    [
      ["1 2 3 4", "Perspective, front, side, top"],
      ["F", "Frame everything"],
      ["T", "Paths of toes and hips"],
      ["+ −", "Zoom the timeline"],
      ["0", "Fit the timeline"],
      ["← → Enter", "In a plot: frame by frame, go there"],
    ],
  ],
  [
    "File",
    [
      ["Ctrl O", "Open"],
      ["Ctrl S", "Save labels as JSON"],
      ["?", "These keys"],
    ],
  ],
];

const views: Record<string, CameraView> = { 1: "perspective", 2: "front", 3: "side", 4: "top" };

/** Keys a focused control needs for itself. */
function belongsToControl(event: KeyboardEvent): boolean {
  const at = event.target;
  if (!(at instanceof HTMLElement)) return false;
  if (at.closest("[role=slider]")) return false;
  if (at.matches("input[type=range]")) return /^(Arrow|Home|End|Page)/.test(event.key);
  if (at.closest("input, select, textarea, [role=tablist], [contenteditable]")) return true;
  return /^( |Enter)$/.test(event.key) && at.closest("button, a, summary") !== null;
}

export function onKey(event: KeyboardEvent, openPicker: () => void) {
  if (event.defaultPrevented) return;
  if ((event.ctrlKey || event.metaKey) && !event.altKey) {
    if (command(event, openPicker)) event.preventDefault();
    return;
  }
  // Brackets need AltGr on many keyboards, which some systems tell as Ctrl and Alt.
  const isBracket = /^[[\]]$/.test(event.key);
  if ((!isBracket && (event.ctrlKey || event.altKey)) || event.metaKey || dialog.value) return;
  if (belongsToControl(event)) return;
  if (event.key === "?") {
    dialog.value = "keys";
    return;
  }
  if (!openClip.value) return;
  if (act(event)) event.preventDefault();
}

/** What is done with Ctrl or ⌘ held. */
function command(event: KeyboardEvent, openPicker: () => void): boolean {
  const key = event.key.toLowerCase();
  // A field being typed in takes its own words back.
  const isTyping =
    event.target instanceof Element && event.target.matches("input[type=text], textarea");
  if (key === "o" && !event.shiftKey) openPicker();
  else if (key === "s" && !event.shiftKey && openClip.value) void save("json");
  else if (key === "z" && openClip.value && !isTyping && !dialog.value)
    event.shiftKey ? redo() : undo();
  else if (key === "y" && !event.shiftKey && openClip.value && !isTyping && !dialog.value) redo();
  else return false;
  return true;
}

function act(event: KeyboardEvent): boolean {
  return play(event) || edit(event);
}

const edits: Record<string, () => unknown> = {
  e: selectHere,
  i: startHere,
  o: endHere,
  k: splitHere,
  m: mergeNext,
  delete: remove,
  backspace: remove,
  escape: () => select(undefined),
};

function edit({ key }: KeyboardEvent): boolean {
  const known = edits[key.toLowerCase()];
  if (known) known();
  else if (key === "a" || key === "A") addAgain();
  else return false;
  return true;
}

function play(event: KeyboardEvent): boolean {
  const view = views[event.key];
  if (view) look(view);
  else if (event.key === " ") togglePlay();
  else if (event.key === "ArrowLeft") event.shiftKey ? stepEdge(-1) : step(-1);
  else if (event.key === "ArrowRight") event.shiftKey ? stepEdge(1) : step(1);
  else if (event.key === "Home") jump(0);
  else if (event.key === "End") jump(clip.value?.frames ?? 0);
  else if (event.key === ",") changeSpeed(-1);
  else if (event.key === ".") changeSpeed(1);
  else if (event.key === "l" || event.key === "L") cycleLoop();
  else if (event.key === "[") stepCut(-1);
  else if (event.key === "]") stepCut(1);
  else if (event.key === "s" || event.key === "S") withSegment(segmentHere(), loopSegment);
  else if (event.key === "Enter") withSegment(chosen.value ?? segmentHere(), askForName);
  else if (event.key === "f" || event.key === "F") frameAllRequests.value++;
  else if (event.key === "t" || event.key === "T") trails.value = !trails.value;
  else if (event.key === "n" || event.key === "N") stepDisagreement(event.shiftKey ? -1 : 1);
  else if (event.key === "0") fitTimeline();
  else if (event.key === "+" || event.key === "=") zoomTimeline(0.7);
  else if (event.key === "-") zoomTimeline(1 / 0.7);
  else return false;
  return true;
}

function withSegment(action: Action | undefined, act: (action: Action) => void) {
  if (action) act(action);
}

function jump(to: number) {
  pause();
  seek(to);
}
