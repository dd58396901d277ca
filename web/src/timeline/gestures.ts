import { batch } from "@preact/signals";
import { editSegmentName } from "../actions/analyse/segment";
import { addToTarget, editEdges, resizeSelected, select, selection } from "../actions/edit/edit";
import { moveCutTo, selectCut } from "../actions/edit/edit-cuts";
import {
  type LoopState,
  loopRange,
  loopSegment,
  pause,
  restoreLoop,
  seek,
  seekPlant,
} from "../actions/view/playback";
import { moveEdge, pan, toFrame, zoomAt } from "../model/motion/time-view";
import { moveCut } from "../model/segments/cut-edits";
import { segmentTitle } from "../model/segments/segments";
import { evidenceOpen, pointAt } from "../store/evidence";
import { loop, loopRegion, timeView } from "../store/playback";
import {
  addTarget,
  clip,
  cutPreview,
  cuts,
  dragPreview,
  plants,
  selectedCut,
} from "../store/session";
import { hovered, notify } from "../store/view";
import { createHitTest, type LanePoint } from "./hit-test";
import type { Layout } from "./layout";

/** Longest time between the clicks of a double click, in milliseconds. */
const doubleClickTime = 400;

/** Pointer movement in pixels that turns a click into a drag. */
const dragThreshold = 3;

type Drag =
  | "scrub"
  | "pan"
  | "minimap"
  | "minimap-start"
  | "minimap-end"
  | "pinch"
  /** A looped range, on the ruler. */
  | "range"
  | "cut"
  /** The start or the end of a bar. */
  | "start"
  | "end";

/** Handles the wheel, mouse and touch on the timeline canvas. Returns a function that stops it. */
export function attachGestures(canvas: HTMLCanvasElement, getLayout: () => Layout): () => void {
  const hitTest = createHitTest(canvas, getLayout);
  const frames = () => clip.value?.frames ?? 1;
  const wholeClip = () => ({ start: 0, end: frames() });
  /** Client positions of the pressed pointers, by pointer ID. */
  const pointers = new Map<number, { x: number; y: number }>();
  let drag: Drag | null = null;
  let origin = { x: 0, y: 0 };
  let moved = false;
  let lastClick = { target: "", time: 0 };
  /** Loop before the last click on a segment. */
  let loopBefore: LoopState = { kind: "clip", region: null };
  /** Frame at which the drag of a range began. */
  let rangeOrigin = 0;

  const onWheel = (event: WheelEvent) => {
    event.preventDefault();
    const { x, laneWidth } = hitTest.toLanePoint(event);
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    const view = timeView.value;
    const framesPerPixel = (view.end - view.start) / laneWidth;
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      const by = (event.deltaX || event.deltaY) * unit * framesPerPixel;
      timeView.value = pan(view, by, frames());
      return;
    }
    // Trackpad pinches arrive as wheel events with small steps and ctrlKey set.
    const factor = Math.exp(event.deltaY * unit * (event.ctrlKey ? 0.01 : 0.0016));
    timeView.value = zoomAt(view, toFrame(view, x, laneWidth), factor, frames());
  };

  /** Returns the drag that a press would start. */
  const dragAt = (event: PointerEvent): Drag => {
    const point = hitTest.toLanePoint(event);
    const isTouch = event.pointerType === "touch";
    const minimapPart = hitTest.minimapPartAt(point, isTouch);
    if (minimapPart) return minimapPart;
    if (event.shiftKey && hitTest.isOnRuler(point)) return "range";
    if (event.shiftKey || event.button === 1) return "pan";
    if (hitTest.cutAt(point, isTouch) !== undefined) return "cut";
    return hitTest.edgeAt(point, isTouch)?.edge ?? "scrub";
  };

  const onPointerDown = (event: PointerEvent) => {
    if (event.button > 1) return;
    event.preventDefault();
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 2) {
      drag = "pinch";
      return;
    }
    origin = { x: event.clientX, y: event.clientY };
    hovered.value = null;
    moved = false;
    drag = dragAt(event);
    const point = hitTest.toLanePoint(event);
    if (drag === "start" || drag === "end") {
      const plantRef = hitTest.edgeAt(point, event.pointerType === "touch")?.plantRef;
      if (plantRef) select(plantRef, drag);
      return;
    }
    if (drag === "cut") {
      selectCut(hitTest.cutAt(point, event.pointerType === "touch") ?? null);
      return;
    }
    if (drag === "range") {
      rangeOrigin = frameNear(point);
      return;
    }
    if (drag === "minimap") {
      const at = toFrame(wholeClip(), point.x, point.laneWidth);
      const { start, end } = timeView.value;
      if (at < start || at > end)
        timeView.value = pan(timeView.value, at - (start + end) / 2, frames());
    }
    // A press on a bar may become a click, so it does not move the playhead yet.
    if (drag === "scrub" && (hitTest.isOnRuler(point) || !hitTest.laneAt(point.y))) scrub(point);
  };

  const scrub = ({ x, laneWidth }: LanePoint) => {
    batch(() => {
      pause();
      // Limited to the view, which would otherwise scroll with the playhead.
      const view = timeView.value;
      seek(Math.min(Math.max(toFrame(view, x, laneWidth), view.start), view.end));
    });
  };

  /** Returns the visible frame that is nearest to a position. */
  const frameNear = ({ x, laneWidth }: LanePoint) => {
    const { start, end } = timeView.value;
    const current = Math.floor(toFrame(timeView.value, x, laneWidth));
    return Math.min(Math.max(current, Math.ceil(start)), Math.ceil(end) - 1);
  };

  /** Loops the frames from the origin of the drag to the pointer. */
  const dragRange = (point: LanePoint) => {
    const current = frameNear(point);
    loopRange({
      start: Math.min(rangeOrigin, current),
      end: Math.max(rangeOrigin, current) + 1,
    });
  };

  /** Updates the cursor, the tooltip and the frame under the pointer. */
  const hover = (event: PointerEvent, point: LanePoint) => {
    const segment = hitTest.segmentAt(point);
    canvas.style.cursor = cursorOf(dragAt(event), hitTest.barAt(point) || segment);
    const pointed = hitTest.frameAt(point);
    if (evidenceOpen.value) pointAt(pointed);
    hovered.value = pointed ? { ...pointed, y: point.y } : null;
    canvas.title = segment ? segmentTitle(segment) : "";
  };

  const leave = () => {
    pointAt(undefined);
    hovered.value = null;
  };

  const onPointerMove = (event: PointerEvent) => {
    const point = hitTest.toLanePoint(event);
    const pointer = pointers.get(event.pointerId);
    if (!pointer) {
      hover(event, point);
      return;
    }
    const { x, laneWidth } = point;
    const dx = event.clientX - pointer.x;
    const distance = Math.hypot(event.clientX - origin.x, event.clientY - origin.y);
    if (distance > dragThreshold) moved = true;
    const view = timeView.value;
    const framesPerPixel = (view.end - view.start) / laneWidth;
    if (drag === "pinch") pinch(event, point);
    else if ((drag === "start" || drag === "end") && moved) dragEdge(drag, point);
    else if (drag === "range" && moved) dragRange(point);
    else if (drag === "cut" && moved) dragCut(point);
    else if (drag === "scrub" && moved) scrub(point);
    else if (drag === "pan") timeView.value = pan(view, -dx * framesPerPixel, frames());
    else if (drag === "minimap") timeView.value = pan(view, (dx * frames()) / laneWidth, frames());
    else if (drag === "minimap-start" || drag === "minimap-end") {
      const edge = drag === "minimap-start" ? "start" : "end";
      timeView.value = moveEdge(view, edge, toFrame(wholeClip(), x, laneWidth), frames());
    }
    pointer.x = event.clientX;
    pointer.y = event.clientY;
  };

  /** Moves the preview of an edge to the pointer, and the playhead to the frame at the edge. */
  const dragEdge = (edge: "start" | "end", { x, laneWidth }: LanePoint) => {
    const current = selection.value;
    if (!current) return;
    const { plantRef, track } = current;
    const to = Math.round(toFrame(timeView.value, x, laneWidth));
    const { start, end } = plantRef;
    batch(() => {
      dragPreview.value =
        edge === "start"
          ? { start: Math.min(Math.max(to, 0), end - 1), end }
          : { start, end: Math.min(Math.max(to, start + 1), track.frames) };
      pause();
      seek(edge === "start" ? dragPreview.value.start : dragPreview.value.end - 1);
    });
  };

  /** Moves the preview of the selected cut to the pointer, and the playhead to its frame. */
  const dragCut = ({ x, laneWidth }: LanePoint) => {
    const cut = selectedCut.value;
    if (cut === null) return;
    const to = Math.round(toFrame(timeView.value, x, laneWidth));
    const at = moveCut(cuts.value, cut, to, frames()).at(-1)?.cut ?? cut;
    batch(() => {
      cutPreview.value = at;
      pause();
      seek(at);
    });
  };

  /** Applies the dragged cut. The preview is shown until the edit is done. */
  const endCutDrag = (event: PointerEvent) => {
    const [cut, to] = [selectedCut.value, cutPreview.value];
    if (cut === null || to === null || event.type !== "pointerup") {
      cutPreview.value = null;
      return;
    }
    void moveCutTo(cut, to).then(() => {
      cutPreview.value = null;
    });
  };

  const pinch = (event: PointerEvent, { x, laneWidth }: LanePoint) => {
    const pointer = pointers.get(event.pointerId);
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (!pointer || !other) return;
    const box = canvas.getBoundingClientRect();
    const otherX = other.x - box.left - getLayout().labelWidth;
    const previousSpan = Math.max(20, Math.abs(pointer.x - other.x));
    const span = Math.max(20, Math.abs(event.clientX - other.x));
    const view = timeView.value;
    const middle = toFrame(view, (x + otherX) / 2, laneWidth);
    const zoomed = zoomAt(view, middle, previousSpan / span, frames());
    const shift = ((event.clientX - pointer.x) / 2 / laneWidth) * (zoomed.end - zoomed.start);
    timeView.value = pan(zoomed, -shift, frames());
  };

  const onPointerUp = (event: PointerEvent) => {
    if (!pointers.delete(event.pointerId)) return;
    if (drag === "start" || drag === "end") endEdgeDrag(event);
    else if (drag === "cut") endCutDrag(event);
    else if (drag === "scrub" && !moved && event.type === "pointerup") click(event);
    if (!pointers.size) drag = null;
    if (event.pointerType === "mouse") hover(event, hitTest.toLanePoint(event));
  };

  /** Applies the dragged edge. The preview is shown until the edit is done. */
  const endEdgeDrag = (event: PointerEvent) => {
    const preview = dragPreview.value;
    if (!preview || event.type !== "pointerup") {
      dragPreview.value = null;
      if (!moved) click(event);
      return;
    }
    void resizeSelected(preview).then(() => {
      dragPreview.value = null;
    });
  };

  /** True if the same target was clicked shortly before. */
  const isDoubleClick = (event: PointerEvent, target: string) => {
    const isDouble =
      lastClick.target === target && event.timeStamp - lastClick.time < doubleClickTime;
    lastClick = isDouble ? { target: "", time: 0 } : { target, time: event.timeStamp };
    return isDouble;
  };

  const click = (event: PointerEvent) => {
    const point = hitTest.toLanePoint(event);
    if (hitTest.isOnRuler(point)) {
      lastClick = { target: "", time: 0 };
      return;
    }
    const tappedCut = event.pointerType === "touch" ? hitTest.cutNear(point, true) : undefined;
    if (tappedCut !== undefined && tappedCut !== selectedCut.value) {
      selectCut(tappedCut);
      pause();
      seek(tappedCut);
      return;
    }
    const segment = hitTest.segmentAt(point);
    if (segment) {
      if (isDoubleClick(event, `segment ${segment.number}`)) {
        // The first click looped the segment, which naming does not ask for.
        restoreLoop(loopBefore);
        editSegmentName(segment);
      } else {
        loopBefore = { kind: loop.value, region: loopRegion.value };
        loopSegment(segment);
      }
      return;
    }
    const bar = hitTest.barAt(point);
    if (!bar) {
      const track = hitTest.trackAt(point.y);
      select(undefined);
      scrub(point);
      if (track) {
        addTarget.value = track;
        if (isDoubleClick(event, `${track.side} ${track.part}`)) void addToTarget();
      }
      return;
    }
    const { side, part, start, end } = bar;
    if (isDoubleClick(event, `${side} ${part} ${start}`)) {
      editEdges(bar);
      return;
    }
    if (event.pointerType === "touch") notify("Drag an end of the bar to correct it");
    select(bar);
    const plant = plants.value.find((p) => p.side === side && p.start < end && p.end > start);
    pause();
    if (plant) seekPlant(plant);
    if (!plant || plant.start !== start) seek(start);
  };

  const listeners = new AbortController();
  const options = { signal: listeners.signal };
  canvas.addEventListener("wheel", onWheel, { passive: false, ...options });
  canvas.addEventListener("pointerdown", onPointerDown, options);
  canvas.addEventListener("pointermove", onPointerMove, options);
  canvas.addEventListener("pointerleave", leave, options);
  canvas.addEventListener("pointerup", onPointerUp, options);
  canvas.addEventListener("pointercancel", onPointerUp, options);
  return () => listeners.abort();
}

/** Returns the CSS cursor for a drag; `target` is the bar or segment under the pointer. */
function cursorOf(drag: Drag, target: unknown): string {
  if (drag === "minimap") return "grab";
  if (drag === "minimap-start" || drag === "minimap-end") return "ew-resize";
  if (drag === "start" || drag === "end") return "ew-resize";
  if (drag === "cut") return "ew-resize";
  if (drag === "range") return "crosshair";
  return target ? "pointer" : "default";
}
