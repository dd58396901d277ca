import { toFrame, toX } from "../model/motion/time-view";
import type { PlantRef } from "../model/plants/edits";
import { firstIntervalAfter, intervalAt } from "../model/plants/intervals";
import { nearestCut } from "../model/segments/cut-edits";
import { segmentAt } from "../model/segments/segments";
import { timeView } from "../store/playback";
import { clip, cuts, namedSegments, selected, selectedCut } from "../store/session";
import { isBars, type Layout } from "./layout";
import { margin } from "./scene";

/** Greatest distance from the edge of a bar at which a press grabs it, in pixels. */
const edgeReach = { mouse: 5, touch: 16 };

/** Narrower bars have draggable edges only while they are selected, in pixels. */
const minDraggableWidth = 28;

/** Greatest distance from a minimap handle at which a press grabs it, in pixels. */
const handleReach = { mouse: 7, touch: 18 };

/** A pointer position in pixels, `x` from the left end of the lanes. */
export interface LanePoint {
  x: number;
  y: number;
  /** Width of the lanes, in pixels. */
  laneWidth: number;
}

export type HitTest = ReturnType<typeof createHitTest>;

/** Returns functions that find what is drawn at a position on the timeline canvas. */
export function createHitTest(canvas: HTMLCanvasElement, getLayout: () => Layout) {
  const frames = () => clip.value?.frames ?? 1;

  const toLanePoint = (event: MouseEvent): LanePoint => {
    const box = canvas.getBoundingClientRect();
    const { labelWidth } = getLayout();
    return {
      x: event.clientX - box.left - labelWidth,
      y: event.clientY - box.top,
      laneWidth: box.width - labelWidth - margin,
    };
  };

  /** Returns the part of the minimap at a position; undefined outside of it. */
  const minimapPartAt = ({ x, y, laneWidth }: LanePoint, isTouch: boolean) => {
    if (y < getLayout().minimap.y - 3) return undefined;
    const whole = { start: 0, end: frames() };
    const reach = isTouch ? handleReach.touch : handleReach.mouse;
    const start = toX(whole, timeView.value.start, laneWidth);
    const end = toX(whole, timeView.value.end, laneWidth);
    // In a narrow window the handles shrink, so that its middle can still be dragged.
    const handleWidth = Math.min(reach, (end - start) / 3 + 2);
    if (Math.abs(x - start) < handleWidth) return "minimap-start";
    if (Math.abs(x - end) < handleWidth) return "minimap-end";
    return "minimap";
  };

  const isOnRuler = ({ y }: LanePoint) => y < getLayout().ruler.height;

  /** Returns the frame at a position on the lanes. */
  const frameAt = ({ x, y, laneWidth }: LanePoint) => {
    const frame = Math.floor(toFrame(timeView.value, x, laneWidth));
    const isOnLanes = x >= 0 && y < getLayout().minimap.y - 3;
    return isOnLanes && frame < frames() ? { frame } : undefined;
  };

  /** Returns the lane of bars or segments at a height. */
  const laneAt = (y: number) =>
    getLayout().lanes.find(
      (lane) =>
        (isBars(lane) || lane.kind === "segments") && y >= lane.y && y <= lane.y + lane.height,
    );

  /** Returns the track of a foot at a height. */
  const trackAt = (y: number) => {
    const lane = laneAt(y);
    return lane && isBars(lane) ? { side: lane.side, part: lane.kind } : undefined;
  };

  const barAt = ({ x, y, laneWidth }: LanePoint): PlantRef | undefined => {
    const lane = laneAt(y);
    if (!lane || !isBars(lane)) return undefined;
    const { intervals } = lane.track;
    const i = intervalAt(intervals, toFrame(timeView.value, x, laneWidth));
    if (i < 0) return undefined;
    const { side, kind: part } = lane;
    return { side, part, start: intervals[i] ?? 0, end: intervals[i + 1] ?? 0 };
  };

  const segmentAtPoint = ({ x, y, laneWidth }: LanePoint) =>
    laneAt(y)?.kind === "segments"
      ? segmentAt(namedSegments.value, toFrame(timeView.value, x, laneWidth))
      : undefined;

  /** Returns the cut near a position on the segments. */
  const cutNear = (point: LanePoint, isTouch: boolean): number | undefined => {
    const { x, y, laneWidth } = point;
    if (laneAt(y)?.kind !== "segments" || isOnRuler(point)) return undefined;
    const cut = nearestCut(cuts.value, toFrame(timeView.value, x, laneWidth));
    const reach = isTouch ? edgeReach.touch : edgeReach.mouse;
    if (cut === undefined) return undefined;
    return Math.abs(x - toX(timeView.value, cut, laneWidth)) <= reach ? cut : undefined;
  };

  /** Returns the cut that a press grabs; by touch, only the selected one, which a tap selects. */
  const cutAt = (point: LanePoint, isTouch: boolean): number | undefined => {
    const cut = cutNear(point, isTouch);
    return isTouch && cut !== selectedCut.value ? undefined : cut;
  };

  /** Returns the draggable edge of a bar; by touch, only the selected bar has draggable edges. */
  const edgeAt = (
    point: LanePoint,
    isTouch: boolean,
  ): { plantRef: PlantRef; edge: "start" | "end" } | undefined => {
    const { x, y, laneWidth } = point;
    const lane = laneAt(y);
    if (!lane || !isBars(lane) || isOnRuler(point)) return undefined;
    const reach = isTouch ? edgeReach.touch : edgeReach.mouse;
    const view = timeView.value;
    const framesPerPixel = (view.end - view.start) / laneWidth;
    const { intervals } = lane.track;
    const i = firstIntervalAfter(intervals, toFrame(view, x, laneWidth) - reach * framesPerPixel);
    const [start, end] = [intervals[i], intervals[i + 1]];
    if (start === undefined || end === undefined) return undefined;
    const plantRef = { side: lane.side, part: lane.kind, start, end };
    const selection = selected.value;
    const isSelected =
      selection?.start === start &&
      selection.side === plantRef.side &&
      selection.part === plantRef.part;
    const isTooNarrow = (end - start) / framesPerPixel < minDraggableWidth;
    if (!isSelected && (isTouch || isTooNarrow)) return undefined;
    const toStart = Math.abs(x - toX(view, start, laneWidth));
    const toEnd = Math.abs(x - toX(view, end, laneWidth));
    if (Math.min(toStart, toEnd) > reach) return undefined;
    return { plantRef, edge: toStart < toEnd ? "start" : "end" };
  };

  return {
    toLanePoint,
    minimapPartAt,
    isOnRuler,
    frameAt,
    laneAt,
    trackAt,
    barAt,
    segmentAt: segmentAtPoint,
    edgeAt,
    cutAt,
    cutNear,
  };
}
