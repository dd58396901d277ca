import { toX } from "../model/motion/time-view";
import { plantsWithin } from "../model/plants/plants";
import type { Track } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import { drawPath } from "../util/draw-path";
import type { Bars } from "./layout";
import { font, type Scene } from "./scene";
import { forEachVisible } from "./visible-intervals";

/** Plants with less space, in pixels, have no whiskers. */
const minWhiskerSpace = 20;

/** Shorter whiskers are not drawn, in pixels. */
const minWhisker = 3;

/** Cache of `editedIntervalsOf`. */
const editedIntervals = new WeakMap<Track, Uint32Array>();

/** Draws an interval: hatched for the heel, filled otherwise. */
export function paintBar(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  lane: Bars,
  from: number,
  to: number,
  y: number,
  height: number,
) {
  const width = Math.max(1.5, to - from - 1);
  if (width <= 3) {
    // Too narrow for a texture.
    ctx.fillStyle = theme[lane.side];
    ctx.fillRect(from, y, width, height);
    return;
  }
  ctx.beginPath();
  ctx.roundRect(from, y, width, height, Math.min(3, width / 2));
  if (lane.kind !== "heel") {
    ctx.fillStyle = theme[lane.side];
    ctx.fill();
    return;
  }
  ctx.fillStyle = theme.hatch[lane.side];
  ctx.fill();
  ctx.beginPath();
  ctx.roundRect(
    from + 0.75,
    y + 0.75,
    Math.max(0.5, width - 1.5),
    height - 1.5,
    Math.min(2.5, width / 2),
  );
  drawPath(ctx, theme[lane.side], 1.5);
}

/** Draws the intervals of one part of one foot, with their confidence, edits and numbers. */
export function paintBars(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  lane: Bars,
  laneWidth: number,
) {
  const { view, theme } = scene;
  ctx.fillStyle = theme.lane;
  ctx.fillRect(0, lane.y, laneWidth, lane.height);
  forEachVisible(lane.track.intervals, view, laneWidth, (from, to, isMerged) => {
    if (isMerged) paintMerged(ctx, theme[lane.side], from, to, lane.y, lane.height);
    else paintBar(ctx, theme, lane, from, to, lane.y, lane.height);
  });
  ctx.fillStyle = theme.uncertain;
  forEachVisible(lane.track.uncertain, view, laneWidth, (from, to, isMerged) => {
    // Merged ranges would cover whole bars.
    if (!isMerged) ctx.fillRect(from, lane.y + 1, Math.max(1, to - from), lane.height - 2);
  });
  paintEditedMarks(ctx, scene, lane, laneWidth);
  if (lane.isPrincipal) {
    paintWhiskers(ctx, scene, lane, laneWidth);
    paintPlantNumbers(ctx, scene, lane, laneWidth);
  }
  paintSimilar(ctx, scene, lane, laneWidth);
  paintSelection(ctx, scene, lane, laneWidth);
}

/** Draws a line under edited bars. */
function paintEditedMarks(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  lane: Bars,
  laneWidth: number,
) {
  ctx.fillStyle = scene.theme.text;
  forEachVisible(editedIntervalsOf(lane.track), scene.view, laneWidth, (from, to, isMerged) => {
    // A merged range does not show which of its bars are edited.
    if (!isMerged) ctx.fillRect(from, lane.y + lane.height - 1.5, Math.max(2, to - from - 1), 2);
  });
}

/** Draws foot strikes and foot offs with whiskers of one standard deviation on either side. */
function paintWhiskers(ctx: CanvasRenderingContext2D, scene: Scene, lane: Bars, laneWidth: number) {
  const { view, theme, rate } = scene;
  const visible = plantsWithin(scene.plants, lane.side, view);
  if (visible.length * minWhiskerSpace > laneWidth) return;
  const pixelsPerSecond = (rate * laneWidth) / (view.end - view.start);
  const y = Math.round(lane.y + lane.height / 2);
  ctx.fillStyle = theme.text;
  for (const { strike, off } of visible) {
    for (const instant of [strike, off]) {
      if (!instant) continue;
      const half = instant.uncertainty * pixelsPerSecond;
      if (half < minWhisker) continue;
      // The instant of a frame is in the middle of its width.
      const x = toX(view, instant.time * rate + 0.5, laneWidth);
      const [from, to] = [Math.round(x - half), Math.round(x + half)];
      ctx.fillRect(from, y - 0.5, to - from, 1);
      for (const end of [from, to]) ctx.fillRect(end - 0.5, y - 3, 1, 6);
    }
  }
}

/** Draws a frame with a handle at each end around the selected bar. */
function paintSelection(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  lane: Bars,
  laneWidth: number,
) {
  const { view, theme, selected, selectedEdge } = scene;
  if (selected?.side !== lane.side || selected.part !== lane.kind) return;
  const from = toX(view, selected.start, laneWidth);
  const to = Math.max(from + 3, toX(view, selected.end, laneWidth) - 1);
  const [top, height] = [lane.y - 1.5, lane.height + 3];
  ctx.beginPath();
  ctx.roundRect(from - 1.5, top, to - from + 3, height, 4);
  drawPath(ctx, theme.text, 1.5);
  ctx.fillStyle = theme.text;
  ctx.beginPath();
  for (const [edge, x] of [
    ["start", from - 4],
    ["end", to],
  ] as const) {
    // The edge that keys move is thicker.
    const extra = edge === selectedEdge ? 2 : 0;
    ctx.roundRect(edge === "start" ? x - extra : x, top - extra, 4 + extra, height + 2 * extra, 2);
  }
  ctx.fill();
}

/** Draws offered changes: frames that would be planted are outlined, and those that would not are crossed out. */
function paintSimilar(ctx: CanvasRenderingContext2D, scene: Scene, lane: Bars, laneWidth: number) {
  const { view, theme, similar } = scene;
  for (const { side, part, start, end, planted } of similar) {
    if (side !== lane.side || part !== lane.kind || end < view.start || start > view.end) continue;
    const from = toX(view, start, laneWidth);
    const to = Math.max(from + 2, toX(view, end, laneWidth));
    ctx.fillStyle = planted ? theme.tint[side] : theme.lane;
    ctx.fillRect(from, lane.y, to - from, lane.height);
    ctx.beginPath();
    ctx.rect(from, lane.y + 0.5, to - from, lane.height - 1);
    if (!planted) {
      ctx.moveTo(from, lane.y + lane.height);
      ctx.lineTo(to, lane.y);
    }
    drawPath(ctx, theme.accent, 1.5);
  }
}

/** Draws several merged intervals; they are translucent, unlike a single interval. */
export function paintMerged(
  ctx: CanvasRenderingContext2D,
  color: string,
  from: number,
  to: number,
  y: number,
  height: number,
) {
  ctx.globalAlpha = 0.4;
  ctx.fillStyle = color;
  ctx.fillRect(from, y, to - from, height);
  ctx.globalAlpha = 1;
}

/** Draws the plant numbers on the bars that are wide enough. */
function paintPlantNumbers(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  lane: Bars,
  laneWidth: number,
) {
  const { view, theme } = scene;
  const visible = plantsWithin(scene.plants, lane.side, view);
  // Early exit: most bars are narrower than the shortest number.
  if (visible.length * 6 > laneWidth) return;
  ctx.font = font(lane.height > 20 ? 11 : 10, 600);
  ctx.textAlign = "center";
  const centerY = lane.y + lane.height / 2;
  for (const plant of visible) {
    const from = Math.max(0, toX(view, plant.start, laneWidth));
    const to = Math.min(laneWidth, toX(view, plant.end, laneWidth));
    const text = String(plant.number);
    const width = ctx.measureText(text).width + 6;
    if (to - from < width) continue;
    const x = (from + to) / 2;
    if (lane.kind === "heel") {
      ctx.fillStyle = theme[lane.side];
      ctx.fillRect(x - width / 2, lane.y + 2, width, lane.height - 4);
    }
    ctx.fillStyle = theme.textOnSide;
    ctx.fillText(text, x, centerY + 0.5);
  }
}

/** Returns the edited intervals of a track. */
function editedIntervalsOf(track: Track): Uint32Array {
  let edited = editedIntervals.get(track);
  if (!edited) {
    edited = track.intervals.filter((_, i) => track.edited[i >> 1] === 1);
    editedIntervals.set(track, edited);
  }
  return edited;
}
