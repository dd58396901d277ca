import { toX } from "../model/time-view";
import { rulerLabel, timeSteps } from "../util/axis-steps";
import { formatCount } from "../util/format";
import { font, margin, type Scene } from "./scene";

export function paintRuler(pen: CanvasRenderingContext2D, scene: Scene, inner: number) {
  const { ink, layout, view, rate } = scene;
  const bottom = layout.ruler.height;
  // Above the playhead's handle, which would cover the numbers.
  const middle = 9;
  const lanesEnd = layout.minimap.y - 6;
  pen.fillStyle = ink.line;
  pen.fillRect(0, bottom - 1, inner, 1);
  if (scene.loop) {
    const from = Math.max(0, toX(view, scene.loop.start, inner));
    const to = Math.min(inner, toX(view, scene.loop.end, inner));
    pen.fillStyle = ink.text;
    if (to > from) pen.fillRect(from, bottom - 3, to - from, 3);
  }
  const perSecond = (inner * rate) / (view.end - view.start);
  const { major, minor } = timeSteps(perSecond);
  const every = Math.round(major / minor);
  const perFrame = inner / (view.end - view.start);
  pen.textAlign = "left";
  const last = Math.floor(view.end / rate / minor + 1e-6);
  for (let k = Math.ceil(view.start / rate / minor - 1e-6); k <= last; k++) {
    const seconds = k * minor;
    const x = Math.round(toX(view, seconds * rate, inner));
    const big = k % every === 0;
    pen.fillStyle = ink.line;
    if (!big) {
      pen.fillRect(x, bottom - 5, 1, 5);
      continue;
    }
    pen.fillRect(x, bottom - 12, 1, lanesEnd - bottom + 12);
    const text = rulerLabel(seconds, major);
    pen.font = font(11);
    const room = pen.measureText(text).width;
    if (x + room + 5 > inner + margin) continue;
    pen.fillStyle = ink.muted;
    pen.fillText(text, x + 5, middle);
    // Close by, the frame joins the second it belongs to, where the next second leaves it room.
    if (perFrame < 8) continue;
    const frame = `f${formatCount(Math.round(seconds * rate))}`;
    pen.font = font(10);
    const end = x + room + 11 + pen.measureText(frame).width;
    if (end + 8 > Math.min(x + major * perSecond, inner + margin)) continue;
    pen.fillText(frame, x + room + 11, middle);
  }
}
