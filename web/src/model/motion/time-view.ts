/** The part of the clip that the timeline shows, in fractional frames. */
export interface TimeView {
  start: number;
  end: number;
}

/** Minimum number of visible frames. */
const minFrames = 8;

/** Limits the length of a view, then moves it into the clip. */
export function clampView(view: TimeView, frames: number): TimeView {
  const total = Math.max(frames, 1);
  const length = Math.min(Math.max(view.end - view.start, Math.min(minFrames, total)), total);
  const start = Math.min(Math.max(view.start, 0), total - length);
  return { start, end: start + length };
}

/** Zooms by `factor` (below 1 zooms in); `frame` stays at the same position on the screen. */
export function zoomAt(view: TimeView, frame: number, factor: number, frames: number): TimeView {
  const total = Math.max(frames, 1);
  const oldLength = view.end - view.start;
  const length = Math.min(Math.max(oldLength * factor, Math.min(minFrames, total)), total);
  const ratio = oldLength > 0 ? (frame - view.start) / oldLength : 0.5;
  const start = frame - ratio * length;
  return clampView({ start, end: start + length }, frames);
}

/** Moves a view by a number of frames. */
export function pan(view: TimeView, by: number, frames: number): TimeView {
  return clampView({ start: view.start + by, end: view.end + by }, frames);
}

/** Moves one edge of a view, as the handles of the minimap do. */
export function moveEdge(view: TimeView, edge: "start" | "end", to: number, frames: number) {
  const minLength = Math.min(minFrames, frames);
  return edge === "start"
    ? { start: Math.min(Math.max(to, 0), view.end - minLength), end: view.end }
    : { start: view.start, end: Math.max(Math.min(to, frames), view.start + minLength) };
}

/** Scrolls by a page if a frame is outside of the view; otherwise returns the same view. */
export function scrollToFrame(view: TimeView, frame: number, frames: number): TimeView {
  if (frame >= view.start && frame <= view.end) return view;
  const length = view.end - view.start;
  const start = frame < view.start ? frame - 0.1 * length : frame - 0.05 * length;
  return clampView({ start, end: start + length }, frames);
}

/** Converts a frame to a horizontal position in pixels. */
export function toX(view: TimeView, frame: number, width: number): number {
  return ((frame - view.start) / (view.end - view.start)) * width;
}

/** Converts a horizontal position in pixels to a fractional frame. */
export function toFrame(view: TimeView, x: number, width: number): number {
  return view.start + (x / width) * (view.end - view.start);
}
