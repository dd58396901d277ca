import { batch } from "@preact/signals";
import { editEdges, resizeSelected, select, selection } from "../actions/edit";
import { loopSegment, pause, seek, seekPlant } from "../actions/playback";
import { editSegmentName } from "../actions/segment";
import type { PlantRef } from "../model/edits";
import { firstIntervalAfter, intervalAt } from "../model/intervals";
import { segmentAt, segmentTitle } from "../model/segments";
import { moveEdge, pan, toFrame, toX, zoomAt } from "../model/time-view";
import { evidenceOpen, pointAt } from "../store/evidence";
import { timeView } from "../store/playback";
import { clip, dragPreview, namedSegments, plants, selected } from "../store/session";
import { isBars, type Layout } from "./layout";
import { margin } from "./scene";

/** A second click on a segment or a bar within this time asks for its name or its edges, in milliseconds. */
const doubleClick = 400;

/** How near to an edge of a bar a press has to be to hold it, in pixels. */
const grip = { mouse: 5, touch: 16 };

/** Bars narrower than this have no edges to hold unless they are selected, in pixels. */
const leastWidth = 28;

type Drag = "scrub" | "pan" | "map" | "map-start" | "map-end" | "pinch" | "start" | "end";

/** Wheel, mouse and fingers on the canvas; returns how to let go. */
export function listenToCanvas(canvas: HTMLCanvasElement, layoutNow: () => Layout): () => void {
  const frames = () => clip.value?.frames ?? 1;
  const fingers = new Map<number, { x: number; y: number }>();
  let drag: Drag | null = null;
  let from = { x: 0, y: 0 };
  let moved = false;
  let before = { what: "", at: 0 };

  const place = (event: MouseEvent) => {
    const box = canvas.getBoundingClientRect();
    const layout = layoutNow();
    return {
      x: event.clientX - box.left - layout.labels,
      y: event.clientY - box.top,
      inner: box.width - layout.labels - margin,
    };
  };

  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const { x, inner } = place(event);
    const line = event.deltaMode === 1 ? 16 : 1;
    const view = timeView.value;
    const perPixel = (view.end - view.start) / inner;
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      const by = (event.deltaX || event.deltaY) * line * perPixel;
      timeView.value = pan(view, by, frames());
      return;
    }
    // A pinch on a trackpad arrives as small steps with ctrl held.
    const factor = Math.exp(event.deltaY * line * (event.ctrlKey ? 0.01 : 0.0016));
    timeView.value = zoomAt(view, toFrame(view, x, inner), factor, frames());
  };

  const partOf = (event: PointerEvent): Drag => {
    const { x, y, inner } = place(event);
    const { minimap } = layoutNow();
    if (y >= minimap.y - 3) {
      const whole = { start: 0, end: frames() };
      const reach = event.pointerType === "touch" ? 18 : 7;
      const start = toX(whole, timeView.value.start, inner);
      const end = toX(whole, timeView.value.end, inner);
      // On a narrow window the edges give way to its middle.
      const near = Math.min(reach, (end - start) / 3 + 2);
      if (Math.abs(x - start) < near) return "map-start";
      if (Math.abs(x - end) < near) return "map-end";
      return "map";
    }
    if (event.shiftKey || event.button === 1) return "pan";
    return edgeAt(event)?.edge ?? "scrub";
  };

  const down = (event: PointerEvent) => {
    if (event.button > 1) return;
    event.preventDefault();
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (fingers.size === 2) {
      drag = "pinch";
      return;
    }
    from = { x: event.clientX, y: event.clientY };
    moved = false;
    drag = partOf(event);
    const { x, y, inner } = place(event);
    if (drag === "start" || drag === "end") {
      const held = edgeAt(event)?.stay;
      if (held) select(held);
      return;
    }
    if (drag === "map") {
      const at = toFrame({ start: 0, end: frames() }, x, inner);
      const { start, end } = timeView.value;
      if (at < start || at > end)
        timeView.value = pan(timeView.value, at - (start + end) / 2, frames());
    }
    // On a bar a press waits: it may become a click that goes to the plant's start.
    if (drag === "scrub" && (y < layoutNow().ruler.height || !laneAt(y))) scrub(x, inner);
  };

  /** The frame under a pointer that is on the lanes. */
  const frameAt = (x: number, y: number, inner: number) => {
    const frame = Math.floor(toFrame(timeView.value, x, inner));
    const isOnLanes = x >= 0 && y < layoutNow().minimap.y - 3;
    return isOnLanes && frame < frames() ? { frame } : undefined;
  };

  const laneAt = (y: number) =>
    layoutNow().lanes.find(
      (lane) =>
        (isBars(lane) || lane.kind === "segments") && y >= lane.y && y <= lane.y + lane.height,
    );

  const scrub = (x: number, inner: number) => {
    batch(() => {
      pause();
      // The playhead must not drag the view along while it is being dragged.
      const view = timeView.value;
      seek(Math.min(Math.max(toFrame(view, x, inner), view.start), view.end));
    });
  };

  const move = (event: PointerEvent) => {
    const { x, y, inner } = place(event);
    const finger = fingers.get(event.pointerId);
    if (!finger) {
      const part = partOf(event);
      canvas.style.cursor =
        part === "map-start" || part === "map-end" || part === "start" || part === "end"
          ? "ew-resize"
          : part === "map"
            ? "grab"
            : barAt(x, y, inner) || segmentUnder(x, y, inner)
              ? "pointer"
              : "default";
      if (evidenceOpen.value) pointAt(frameAt(x, y, inner));
      const segment = segmentUnder(x, y, inner);
      canvas.title = segment ? segmentTitle(segment) : "";
      return;
    }
    const dx = event.clientX - finger.x;
    if (Math.hypot(event.clientX - from.x, event.clientY - from.y) > 3) moved = true;
    const view = timeView.value;
    const perPixel = (view.end - view.start) / inner;
    const whole = { start: 0, end: frames() };
    if (drag === "pinch") pinch(event, x, inner);
    else if ((drag === "start" || drag === "end") && moved) stretch(drag, x, inner);
    else if (drag === "scrub" && moved) scrub(x, inner);
    else if (drag === "pan") timeView.value = pan(view, -dx * perPixel, frames());
    else if (drag === "map") timeView.value = pan(view, (dx * frames()) / inner, frames());
    else if (drag === "map-start")
      timeView.value = moveEdge(view, "start", toFrame(whole, x, inner), frames());
    else if (drag === "map-end")
      timeView.value = moveEdge(view, "end", toFrame(whole, x, inner), frames());
    finger.x = event.clientX;
    finger.y = event.clientY;
  };

  /** The edge that is dragged goes to the pointer, and the view shows the frame there. */
  const stretch = (edge: "start" | "end", x: number, inner: number) => {
    const held = selection.value;
    if (!held) return;
    const { plantRef, track } = held;
    const to = Math.round(toFrame(timeView.value, x, inner));
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

  const pinch = (event: PointerEvent, x: number, inner: number) => {
    const finger = fingers.get(event.pointerId);
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    if (!finger || !other) return;
    const box = canvas.getBoundingClientRect();
    const otherX = other.x - box.left - layoutNow().labels;
    const was = Math.max(20, Math.abs(finger.x - other.x));
    const is = Math.max(20, Math.abs(event.clientX - other.x));
    const view = timeView.value;
    const middle = toFrame(view, (x + otherX) / 2, inner);
    const zoomed = zoomAt(view, middle, was / is, frames());
    const shift = ((event.clientX - finger.x) / 2 / inner) * (zoomed.end - zoomed.start);
    timeView.value = pan(zoomed, -shift, frames());
  };

  /** The edge of a bar that a press would hold; a finger holds those of the selected bar alone. */
  const edgeAt = (event: PointerEvent): { stay: PlantRef; edge: "start" | "end" } | undefined => {
    const { x, y, inner } = place(event);
    const lane = laneAt(y);
    if (!lane || !isBars(lane) || y < layoutNow().ruler.height) return undefined;
    const isTouch = event.pointerType === "touch";
    const within = isTouch ? grip.touch : grip.mouse;
    const view = timeView.value;
    const perPixel = (view.end - view.start) / inner;
    const { intervals } = lane.track;
    const at = firstIntervalAfter(intervals, toFrame(view, x, inner) - within * perPixel);
    const [start, end] = [intervals[at], intervals[at + 1]];
    if (start === undefined || end === undefined) return undefined;
    const stay = { side: lane.side, part: lane.kind, start, end };
    const chosen = selected.value;
    const isChosen =
      chosen?.start === start && chosen.side === stay.side && chosen.part === stay.part;
    if (!isChosen && (isTouch || (end - start) / perPixel < leastWidth)) return undefined;
    const gaps = [Math.abs(x - toX(view, start, inner)), Math.abs(x - toX(view, end, inner))];
    const [toStart = 0, toEnd = 0] = gaps;
    if (Math.min(toStart, toEnd) > within) return undefined;
    return { stay, edge: toStart < toEnd ? "start" : "end" };
  };

  const barAt = (x: number, y: number, inner: number) => {
    const lane = laneAt(y);
    if (!lane || !isBars(lane)) return undefined;
    const at = intervalAt(lane.track.intervals, toFrame(timeView.value, x, inner));
    return at < 0
      ? undefined
      : { lane, start: lane.track.intervals[at] ?? 0, end: lane.track.intervals[at + 1] ?? 0 };
  };

  const segmentUnder = (x: number, y: number, inner: number) =>
    laneAt(y)?.kind === "segments"
      ? segmentAt(namedSegments.value, toFrame(timeView.value, x, inner))
      : undefined;

  const up = (event: PointerEvent) => {
    if (!fingers.delete(event.pointerId)) return;
    if (drag === "start" || drag === "end") letGo(event);
    else if (drag === "scrub" && !moved && event.type === "pointerup") click(event);
    if (!fingers.size) drag = null;
  };

  /** The edge stays where it was dragged to; until then the bar is drawn as it would be. */
  const letGo = (event: PointerEvent) => {
    const to = dragPreview.value;
    if (!to || event.type !== "pointerup") {
      dragPreview.value = null;
      if (!moved) click(event);
      return;
    }
    void Promise.resolve(resizeSelected(to)).then(() => {
      dragPreview.value = null;
    });
  };

  /** Whether the same was clicked a moment ago. */
  const isAgain = (event: PointerEvent, what: string) => {
    const again = before.what === what && event.timeStamp - before.at < doubleClick;
    before = again ? { what: "", at: 0 } : { what, at: event.timeStamp };
    return again;
  };

  const click = (event: PointerEvent) => {
    const { x, y, inner } = place(event);
    if (y < layoutNow().ruler.height) {
      before = { what: "", at: 0 };
      return;
    }
    const segment = segmentUnder(x, y, inner);
    if (segment) {
      if (isAgain(event, `segment ${segment.number}`)) editSegmentName(segment);
      else loopSegment(segment);
      return;
    }
    const bar = barAt(x, y, inner);
    if (!bar) {
      select(undefined);
      scrub(x, inner);
      return;
    }
    const { side, kind: part } = bar.lane;
    const stay = { side, part, start: bar.start, end: bar.end };
    if (isAgain(event, `${side} ${part} ${bar.start}`)) {
      editEdges(stay);
      return;
    }
    select(stay);
    const plant = plants.value.find(
      (p) => p.side === side && p.start < bar.end && p.end > bar.start,
    );
    pause();
    if (plant) seekPlant(plant);
    if (!plant || plant.start !== bar.start) seek(bar.start);
  };

  const off = new AbortController();
  const quiet = { signal: off.signal };
  canvas.addEventListener("wheel", wheel, { passive: false, ...quiet });
  canvas.addEventListener("pointerdown", down, quiet);
  canvas.addEventListener("pointermove", move, quiet);
  canvas.addEventListener("pointerleave", () => pointAt(undefined), quiet);
  canvas.addEventListener("pointerup", up, quiet);
  canvas.addEventListener("pointercancel", up, quiet);
  return () => off.abort();
}
