import { toX } from "../model/motion/time-view";
import { rulerLabel, timeSteps } from "../util/axis-steps";
import { formatCount } from "../util/format";
import { font, margin, type Scene } from "./scene";

/** Draws the time axis, the vertical grid lines and the loop region. */
export function paintRuler(ctx: CanvasRenderingContext2D, scene: Scene, laneWidth: number) {
  const { theme, layout, view, rate } = scene;
  const bottom = layout.ruler.height;
  // Above the handle of the playhead.
  const centerY = 9;
  const lanesEnd = layout.minimap.y - 6;
  ctx.fillStyle = theme.border;
  ctx.fillRect(0, bottom - 1, laneWidth, 1);
  if (scene.loop) {
    const from = Math.max(0, toX(view, scene.loop.start, laneWidth));
    const to = Math.min(laneWidth, toX(view, scene.loop.end, laneWidth));
    ctx.fillStyle = theme.text;
    if (to > from) ctx.fillRect(from, bottom - 3, to - from, 3);
  }
  const pixelsPerSecond = (laneWidth * rate) / (view.end - view.start);
  const { major, minor } = timeSteps(pixelsPerSecond);
  const ticksPerLabel = Math.round(major / minor);
  const pixelsPerFrame = laneWidth / (view.end - view.start);
  ctx.textAlign = "left";
  const last = Math.floor(view.end / rate / minor + 1e-6);
  for (let tick = Math.ceil(view.start / rate / minor - 1e-6); tick <= last; tick++) {
    const seconds = tick * minor;
    const x = Math.round(toX(view, seconds * rate, laneWidth));
    const isMajor = tick % ticksPerLabel === 0;
    ctx.fillStyle = theme.border;
    if (!isMajor) {
      ctx.fillRect(x, bottom - 5, 1, 5);
      continue;
    }
    ctx.fillRect(x, bottom - 12, 1, lanesEnd - bottom + 12);
    const text = rulerLabel(seconds, major);
    ctx.font = font(11);
    const textWidth = ctx.measureText(text).width;
    if (x + textWidth + 5 > laneWidth + margin) continue;
    ctx.fillStyle = theme.muted;
    ctx.fillText(text, x + 5, centerY);
    // At high zoom the frame number follows the time if it fits.
    if (pixelsPerFrame < 8) continue;
    const frame = `f${formatCount(Math.round(seconds * rate))}`;
    ctx.font = font(10);
    const end = x + textWidth + 11 + ctx.measureText(frame).width;
    if (end + 8 > Math.min(x + major * pixelsPerSecond, laneWidth + margin)) continue;
    ctx.fillText(frame, x + textWidth + 11, centerY);
  }
}
