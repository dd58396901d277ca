/** The part of the clip the timeline shows, in frames (not whole while zooming). */
export interface TimeView {
  start: number;
  end: number;
}

/** The closest look: fewer frames than this tell nothing more. */
const minFrames = 8;

/** Keeps a view inside the clip, its length first. */
export function clampView(view: TimeView, frames: number): TimeView {
  const total = Math.max(frames, 1);
  const length = Math.min(Math.max(view.end - view.start, Math.min(minFrames, total)), total);
  const start = Math.min(Math.max(view.start, 0), total - length);
  return { start, end: start + length };
}

/** Zooms by `factor` (< 1 is closer) with the frame under the pointer held still. */
export function zoomAt(view: TimeView, frame: number, factor: number, frames: number): TimeView {
  const total = Math.max(frames, 1);
  const before = view.end - view.start;
  const length = Math.min(Math.max(before * factor, Math.min(minFrames, total)), total);
  const ratio = before > 0 ? (frame - view.start) / before : 0.5;
  const start = frame - ratio * length;
  return clampView({ start, end: start + length }, frames);
}

export function pan(view: TimeView, by: number, frames: number): TimeView {
  return clampView({ start: view.start + by, end: view.end + by }, frames);
}

/** Moves one edge, as the minimap's handles do; the other edge stays. */
export function moveEdge(view: TimeView, edge: "start" | "end", to: number, frames: number) {
  const least = Math.min(minFrames, frames);
  return edge === "start"
    ? { start: Math.min(Math.max(to, 0), view.end - least), end: view.end }
    : { start: view.start, end: Math.max(Math.min(to, frames), view.start + least) };
}

/** Turns the page when the playhead has left the view; otherwise the same view. */
export function scrollToFrame(view: TimeView, frame: number, frames: number): TimeView {
  if (frame >= view.start && frame <= view.end) return view;
  const length = view.end - view.start;
  const start = frame < view.start ? frame - 0.1 * length : frame - 0.05 * length;
  return clampView({ start, end: start + length }, frames);
}

export function toX(view: TimeView, frame: number, width: number): number {
  return ((frame - view.start) / (view.end - view.start)) * width;
}

export function toFrame(view: TimeView, x: number, width: number): number {
  return view.start + (x / width) * (view.end - view.start);
}
