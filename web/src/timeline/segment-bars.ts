import { firstIntervalAfter } from "../model/intervals";
import { type NamedSegment, segmentIndexAt } from "../model/segments";
import { toX } from "../model/time-view";
import type { Segment } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import type { SegmentLane } from "./layout";
import type { Scene } from "./scene";
import { fitted, widthOf } from "./text";

const textSize = 11;

/**
 * Our segments. What repeats is beaded and bears a loop, what does not is underlined and bears
 * an arrow, what goes over into the next is hatched; the one that is looped is filled.
 */
export function paintSegments(
  pen: CanvasRenderingContext2D,
  scene: Scene,
  lane: SegmentLane,
  inner: number,
) {
  const { view, ink, namedSegments, loopedSegment, segmentation } = scene;
  for (let i = segmentIndexAt(namedSegments, view.start); i < namedSegments.length; i++) {
    const action = namedSegments[i] as NamedSegment;
    if (action.start > view.end) break;
    const from = toX(view, action.start, inner);
    const to = toX(view, action.end, inner);
    const isChosen = action === loopedSegment;
    box(pen, from, to, lane.y, lane.height, 3);
    pen.fillStyle = isChosen ? ink.text : ink.raised;
    pen.fill();
    if (!isChosen) outline(pen, ink.edge, from, to, lane.y, lane.height);
    underline(pen, isChosen ? ink.ground : ink.muted, action.kind, from, to, lane.y + lane.height);
  }
  paintTransitions(pen, scene, lane, inner);
  for (let i = segmentIndexAt(namedSegments, view.start); i < namedSegments.length; i++) {
    const action = namedSegments[i] as NamedSegment;
    if (action.start > view.end) break;
    if (isWithin(segmentation?.transitions, action.start)) {
      pen.fillStyle = ink.text;
      pen.fillRect(
        Math.round(toX(view, action.start, inner)) - 1,
        lane.y + 1,
        1.5,
        lane.height - 2,
      );
    }
    const color = action === loopedSegment ? ink.ground : ink.text;
    nameAction(pen, scene, action, lane, inner, color);
  }
}

/** Whether a cut lies inside a transition rather than at its end. */
function isWithin(spans: Uint32Array | undefined, frame: number): boolean {
  if (!spans?.length) return false;
  const at = firstIntervalAfter(spans, frame);
  return at < spans.length && (spans[at] as number) < frame;
}

function box(
  pen: CanvasRenderingContext2D,
  from: number,
  to: number,
  y: number,
  height: number,
  radius: number,
) {
  const width = Math.max(1.5, to - from - 1);
  pen.beginPath();
  pen.roundRect(from, y, width, height, Math.min(radius, width / 2));
}

function outline(
  pen: CanvasRenderingContext2D,
  color: string,
  from: number,
  to: number,
  y: number,
  height: number,
) {
  const width = to - from - 2;
  if (width < 2) return;
  pen.beginPath();
  pen.roundRect(from + 0.5, y + 0.5, width, height - 1, Math.min(2.5, width / 2));
  pen.lineWidth = 1;
  pen.strokeStyle = color;
  pen.stroke();
}

/** Beads under what repeats, a line under what does not, nothing where nobody knows. */
function underline(
  pen: CanvasRenderingContext2D,
  color: string,
  kind: Segment["kind"],
  from: number,
  to: number,
  bottom: number,
) {
  if (kind === "action" || to - from < 10) return;
  pen.fillStyle = color;
  if (kind === "aperiodic") {
    pen.fillRect(from + 4, bottom - 4.5, to - from - 9, 1.5);
    return;
  }
  for (let x = Math.max(from, -6) + 5; x < to - 4 && x < 8000; x += 6) {
    pen.fillRect(x, bottom - 5, 2.5, 2.5);
  }
}

function paintTransitions(
  pen: CanvasRenderingContext2D,
  { view, ink, segmentation }: Scene,
  lane: SegmentLane,
  inner: number,
) {
  const spans = segmentation?.transitions;
  if (!spans) return;
  for (let i = firstIntervalAfter(spans, view.start); i < spans.length; i += 2) {
    const start = spans[i] as number;
    if (start > view.end) break;
    const from = toX(view, start, inner);
    const width = Math.max(2, toX(view, spans[i + 1] as number, inner) - from - 1);
    pen.fillStyle = ink.ground;
    pen.fillRect(from, lane.y, width, lane.height);
    pen.fillStyle = ink.transition;
    pen.fillRect(from, lane.y + 1, width, lane.height - 2);
  }
}

/** The sign of its kind and its name, or its number, as far as there is room. */
function nameAction(
  pen: CanvasRenderingContext2D,
  { view, ink, segmentation }: Scene,
  action: NamedSegment,
  lane: SegmentLane,
  inner: number,
  color: string,
) {
  const spans = segmentation?.transitions;
  let from = action.start;
  let to = action.end;
  if (spans?.length) {
    // Nothing is written on the hatching.
    const before = firstIntervalAfter(spans, action.start);
    if ((spans[before] ?? to) <= from) from = Math.min(spans[before + 1] as number, to);
    const after = firstIntervalAfter(spans, action.end - 1);
    if ((spans[after] ?? to) < to) to = Math.max(spans[after] as number, from);
  }
  let x = Math.max(0, toX(view, from, inner)) + 7;
  const end = Math.min(inner, toX(view, to, inner)) - 7;
  // From afar there is room for nothing.
  if (end <= x) return;
  const middle = lane.y + lane.height / 2 + (action.kind === "action" ? 0.5 : -1);
  pen.fillStyle = color;
  pen.strokeStyle = color;
  const text = action.name || numeral(action.number);
  // The name goes before the sign: beads and lines tell the kind as well.
  const wanted = Math.min(widthOf(pen, ink, text, textSize), 24);
  if (action.kind !== "action" && end - x >= 15 + wanted) {
    sign(pen, action.kind, x, middle);
    x += 15;
  }
  const shown = fitted(pen, ink, text, end - x, textSize);
  pen.textAlign = "left";
  if (shown) pen.fillText(shown, x, middle);
}

/** A loop for what repeats, an arrow for what does not; 10 pixels wide. */
function sign(pen: CanvasRenderingContext2D, kind: Segment["kind"], x: number, y: number) {
  pen.lineWidth = 1.3;
  pen.beginPath();
  if (kind === "periodic") {
    pen.arc(x + 4.5, y, 3.6, -0.9, 4.6);
    pen.moveTo(x + 7.2, y - 5.2);
    pen.lineTo(x + 7, y - 2.4);
    pen.lineTo(x + 9.8, y - 2.4);
  } else {
    pen.moveTo(x, y);
    pen.lineTo(x + 9, y);
    pen.moveTo(x + 6, y - 3);
    pen.lineTo(x + 9, y);
    pen.lineTo(x + 6, y + 3);
  }
  pen.stroke();
}

/** The motifs, each with the number of its class: those that are alike have the same. */
export function paintMotifs(
  pen: CanvasRenderingContext2D,
  { view, ink, segmentation }: Scene,
  lane: SegmentLane,
  inner: number,
) {
  if (!segmentation) return;
  const { motifs, classes } = segmentation;
  pen.fillStyle = ink.lane;
  pen.fillRect(0, lane.y, inner, lane.height);
  pen.textAlign = "center";
  for (let i = firstIntervalAfter(motifs, view.start); i < motifs.length; i += 2) {
    const start = motifs[i] as number;
    if (start > view.end) break;
    const from = toX(view, start, inner);
    const to = toX(view, motifs[i + 1] as number, inner);
    pen.fillStyle = ink.edge;
    pen.fillRect(Math.round(from), lane.y, 1, lane.height);
    const text = numeral(classes[i / 2] as number);
    const left = Math.max(0, from);
    const right = Math.min(inner, to);
    if (right - left < widthOf(pen, ink, text, 10) + 5) continue;
    pen.fillStyle = ink.muted;
    pen.fillText(text, (left + right) / 2 + 0.5, lane.y + lane.height / 2 + 0.5);
  }
}

const numerals: string[] = [];

function numeral(n: number): string {
  numerals[n] ??= String(n);
  return numerals[n];
}

/** Someone else's segments: outlines of ours, with their names. */
export function paintReferenceSegments(
  pen: CanvasRenderingContext2D,
  { view, ink, referenceSegments }: Scene,
  lane: SegmentLane,
  inner: number,
) {
  const segments = referenceSegments?.segments ?? [];
  pen.textAlign = "left";
  for (let i = segmentIndexAt(segments, view.start); i < segments.length; i++) {
    const { start, end, label } = segments[i] as Segment;
    if (start > view.end) break;
    const from = toX(view, start, inner);
    const to = toX(view, end, inner);
    outline(pen, ink.muted, from, to, lane.y, lane.height);
    const x = Math.max(0, from) + 6;
    const shown = fitted(pen, ink, label, Math.min(inner, to) - 6 - x, 10);
    pen.fillStyle = ink.muted;
    if (shown) pen.fillText(shown, x, lane.y + lane.height / 2 + 0.5);
  }
}

/** A small bar as they look, for the label of their lane. */
export function segmentSwatch(
  pen: CanvasRenderingContext2D,
  ink: CanvasTheme,
  x: number,
  y: number,
) {
  box(pen, x, x + 13, y, 10, 3);
  pen.fillStyle = ink.raised;
  pen.fill();
  outline(pen, ink.edge, x, x + 13, y, 10);
  pen.fillStyle = ink.edge;
  pen.fillRect(x + 6, y, 1, 10);
}
