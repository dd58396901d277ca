import { toX } from "../model/motion/time-view";
import { firstIntervalAfter } from "../model/plants/intervals";
import { type NamedSegment, segmentIndexAt } from "../model/segments/segments";
import type { Segment } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import { drawPath } from "../util/draw-path";
import type { SegmentLane } from "./layout";
import type { Scene } from "./scene";
import { textWidth, truncateText } from "./text";

const textSize = 11;

/**
 * Draws the segments. Periodic segments have a dotted line and a loop icon, aperiodic segments a solid
 * line and an arrow; transitions are hatched, and the looped segment is filled.
 */
export function paintSegments(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  lane: SegmentLane,
  laneWidth: number,
) {
  const { view, theme, namedSegments, loopedSegment, segmentation } = scene;
  for (let i = segmentIndexAt(namedSegments, view.start); i < namedSegments.length; i++) {
    const segment = namedSegments[i] as NamedSegment;
    if (segment.start > view.end) break;
    const from = toX(view, segment.start, laneWidth);
    const to = toX(view, segment.end, laneWidth);
    const isLooped = segment === loopedSegment;
    addBarPath(ctx, from, to, lane.y, lane.height, 3);
    ctx.fillStyle = isLooped ? theme.text : theme.raised;
    ctx.fill();
    if (!isLooped) paintOutline(ctx, theme.borderStrong, from, to, lane.y, lane.height);
    paintKindMark(
      ctx,
      isLooped ? theme.background : theme.muted,
      segment.kind,
      from,
      to,
      lane.y + lane.height,
    );
  }
  paintTransitions(ctx, scene, lane, laneWidth);
  for (let i = segmentIndexAt(namedSegments, view.start); i < namedSegments.length; i++) {
    const segment = namedSegments[i] as NamedSegment;
    if (segment.start > view.end) break;
    if (isInsideInterval(segmentation?.transitions, segment.start)) {
      ctx.fillStyle = theme.text;
      ctx.fillRect(
        Math.round(toX(view, segment.start, laneWidth)) - 1,
        lane.y + 1,
        1.5,
        lane.height - 2,
      );
    }
    const color = segment === loopedSegment ? theme.background : theme.text;
    paintSegmentText(ctx, scene, segment, lane, laneWidth, color);
  }
  paintSelectedCut(ctx, scene, lane, laneWidth);
}

/** Draws the selected cut as a handle. */
function paintSelectedCut(
  ctx: CanvasRenderingContext2D,
  { view, theme, selectedCut }: Scene,
  lane: SegmentLane,
  laneWidth: number,
) {
  if (selectedCut === null) return;
  const x = Math.round(toX(view, selectedCut, laneWidth)) - 0.5;
  ctx.fillStyle = theme.background;
  ctx.fillRect(x - 4, lane.y - 2, 8, lane.height + 4);
  ctx.fillStyle = theme.text;
  ctx.beginPath();
  ctx.roundRect(x - 2, lane.y - 3, 4, lane.height + 6, 2);
  ctx.fill();
}

/** True if a frame lies inside an interval, not at its start or end. */
function isInsideInterval(intervals: Uint32Array | undefined, frame: number): boolean {
  if (!intervals?.length) return false;
  const i = firstIntervalAfter(intervals, frame);
  return i < intervals.length && (intervals[i] as number) < frame;
}

/** Starts a path of a rounded bar. */
function addBarPath(
  ctx: CanvasRenderingContext2D,
  from: number,
  to: number,
  y: number,
  height: number,
  radius: number,
) {
  const width = Math.max(1.5, to - from - 1);
  ctx.beginPath();
  ctx.roundRect(from, y, width, height, Math.min(radius, width / 2));
}

/** Draws the outline of a bar. */
function paintOutline(
  ctx: CanvasRenderingContext2D,
  color: string,
  from: number,
  to: number,
  y: number,
  height: number,
) {
  const width = to - from - 2;
  if (width < 2) return;
  ctx.beginPath();
  ctx.roundRect(from + 0.5, y + 0.5, width, height - 1, Math.min(2.5, width / 2));
  drawPath(ctx, color, 1);
}

/** Draws a dotted line for periodic segments, a solid line for aperiodic ones, nothing otherwise. */
function paintKindMark(
  ctx: CanvasRenderingContext2D,
  color: string,
  kind: Segment["kind"],
  from: number,
  to: number,
  bottom: number,
) {
  if (kind === "action" || to - from < 10) return;
  ctx.fillStyle = color;
  if (kind === "aperiodic") {
    ctx.fillRect(from + 4, bottom - 4.5, to - from - 9, 1.5);
    return;
  }
  for (let x = Math.max(from, -6) + 5; x < to - 4 && x < 8000; x += 6) {
    ctx.fillRect(x, bottom - 5, 2.5, 2.5);
  }
}

/** Draws the transitions between segments. */
function paintTransitions(
  ctx: CanvasRenderingContext2D,
  { view, theme, segmentation }: Scene,
  lane: SegmentLane,
  laneWidth: number,
) {
  const transitions = segmentation?.transitions;
  if (!transitions) return;
  for (let i = firstIntervalAfter(transitions, view.start); i < transitions.length; i += 2) {
    const start = transitions[i] as number;
    if (start > view.end) break;
    const from = toX(view, start, laneWidth);
    const width = Math.max(2, toX(view, transitions[i + 1] as number, laneWidth) - from - 1);
    ctx.fillStyle = theme.background;
    ctx.fillRect(from, lane.y, width, lane.height);
    ctx.fillStyle = theme.transition;
    ctx.fillRect(from, lane.y + 1, width, lane.height - 2);
  }
}

/** Draws the icon of the kind and the name, the action or the number of a segment, if they fit. */
function paintSegmentText(
  ctx: CanvasRenderingContext2D,
  { view, theme, segmentation }: Scene,
  segment: NamedSegment,
  lane: SegmentLane,
  laneWidth: number,
  color: string,
) {
  const transitions = segmentation?.transitions;
  let from = segment.start;
  let to = segment.end;
  if (transitions?.length) {
    // Text is not drawn over transitions.
    const first = firstIntervalAfter(transitions, segment.start);
    if ((transitions[first] ?? to) <= from) from = Math.min(transitions[first + 1] as number, to);
    const last = firstIntervalAfter(transitions, segment.end - 1);
    if ((transitions[last] ?? to) < to) to = Math.max(transitions[last] as number, from);
  }
  let x = Math.max(0, toX(view, from, laneWidth)) + 7;
  const end = Math.min(laneWidth, toX(view, to, laneWidth)) - 7;
  if (end <= x) return;
  const centerY = lane.y + lane.height / 2 + (segment.kind === "action" ? 0.5 : -1);
  ctx.fillStyle = color;
  const text = segment.name || segment.action || numberText(segment.number);
  // The text has priority over the icon, since the line shows the kind as well.
  const wantedWidth = Math.min(textWidth(ctx, theme, text, textSize), 24);
  if (segment.kind !== "action" && end - x >= 15 + wantedWidth) {
    paintKindIcon(ctx, segment.kind, color, x, centerY);
    x += 15;
  }
  const truncated = truncateText(ctx, theme, text, end - x, textSize);
  ctx.textAlign = "left";
  if (truncated) ctx.fillText(truncated, x, centerY);
}

/** Draws a loop for periodic and an arrow for aperiodic segments, 10 pixels wide. */
function paintKindIcon(
  ctx: CanvasRenderingContext2D,
  kind: Segment["kind"],
  color: string,
  x: number,
  y: number,
) {
  ctx.beginPath();
  if (kind === "periodic") {
    ctx.arc(x + 4.5, y, 3.6, -0.9, 4.6);
    ctx.moveTo(x + 7.2, y - 5.2);
    ctx.lineTo(x + 7, y - 2.4);
    ctx.lineTo(x + 9.8, y - 2.4);
  } else {
    ctx.moveTo(x, y);
    ctx.lineTo(x + 9, y);
    ctx.moveTo(x + 6, y - 3);
    ctx.lineTo(x + 9, y);
    ctx.lineTo(x + 6, y + 3);
  }
  drawPath(ctx, color, 1.3);
}

/** Draws the motifs with the numbers of their classes. */
export function paintMotifs(
  ctx: CanvasRenderingContext2D,
  { view, theme, segmentation }: Scene,
  lane: SegmentLane,
  laneWidth: number,
) {
  if (!segmentation) return;
  const { motifs, classes } = segmentation;
  ctx.fillStyle = theme.lane;
  ctx.fillRect(0, lane.y, laneWidth, lane.height);
  ctx.textAlign = "center";
  for (let i = firstIntervalAfter(motifs, view.start); i < motifs.length; i += 2) {
    const start = motifs[i] as number;
    if (start > view.end) break;
    const from = toX(view, start, laneWidth);
    const to = toX(view, motifs[i + 1] as number, laneWidth);
    ctx.fillStyle = theme.borderStrong;
    ctx.fillRect(Math.round(from), lane.y, 1, lane.height);
    const text = numberText(classes[i / 2] as number);
    const left = Math.max(0, from);
    const right = Math.min(laneWidth, to);
    if (right - left < textWidth(ctx, theme, text, 10) + 5) continue;
    ctx.fillStyle = theme.muted;
    ctx.fillText(text, (left + right) / 2 + 0.5, lane.y + lane.height / 2 + 0.5);
  }
}

/** Cache of `numberText`, which avoids allocations while drawing. */
const numberTexts: string[] = [];

function numberText(n: number): string {
  numberTexts[n] ??= String(n);
  return numberTexts[n];
}

/** Draws the reference segments as outlines with their labels. */
export function paintReferenceSegments(
  ctx: CanvasRenderingContext2D,
  { view, theme, referenceSegments }: Scene,
  lane: SegmentLane,
  laneWidth: number,
) {
  const segments = referenceSegments?.segments ?? [];
  ctx.textAlign = "left";
  for (let i = segmentIndexAt(segments, view.start); i < segments.length; i++) {
    const { start, end, label } = segments[i] as Segment;
    if (start > view.end) break;
    const from = toX(view, start, laneWidth);
    const to = toX(view, end, laneWidth);
    paintOutline(ctx, theme.muted, from, to, lane.y, lane.height);
    const x = Math.max(0, from) + 6;
    const truncated = truncateText(ctx, theme, label, Math.min(laneWidth, to) - 6 - x, 10);
    ctx.fillStyle = theme.muted;
    if (truncated) ctx.fillText(truncated, x, lane.y + lane.height / 2 + 0.5);
  }
}

/** Draws a small segment for the label of the lane. */
export function paintSegmentSwatch(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  x: number,
  y: number,
) {
  addBarPath(ctx, x, x + 13, y, 10, 3);
  ctx.fillStyle = theme.raised;
  ctx.fill();
  paintOutline(ctx, theme.borderStrong, x, x + 13, y, 10);
  ctx.fillStyle = theme.borderStrong;
  ctx.fillRect(x + 6, y, 1, 10);
}
