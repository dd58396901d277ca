import { type Plant, plantsWithin } from "../model/plants";
import { toX } from "../model/time-view";
import type { Track } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import { drawPath } from "../util/draw-path";
import type { Bars } from "./layout";
import { font, type Scene } from "./scene";
import { forEachVisible } from "./visible-intervals";

/** Width that the shortest number needs with its margins, in pixels. */
const minNumberWidth = 20;

/** Shorter whiskers are not drawn, in pixels. */
const minWhisker = 3;

/** Cache of `editedIntervalsOf`. */
const editedIntervals = new WeakMap<Track, Uint32Array>();

/** Draws a contact interval: a horizontal line with a vertical line at each end. */
export function paintBracket(
  ctx: CanvasRenderingContext2D,
  color: string,
  from: number,
  to: number,
  y: number,
  height: number,
) {
  ctx.fillStyle = color;
  const left = Math.round(from);
  const right = Math.max(left + 2, Math.round(to));
  ctx.fillRect(left, y - height / 2, 2, height);
  ctx.fillRect(right - 2, y - height / 2, 2, height);
  ctx.fillRect(left, y - 1, right - left, 2);
}

/** Draws a heel interval (hatched) or a toe interval (filled). */
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
  if (lane.kind === "toe") {
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
  if (lane.kind !== "contact") {
    ctx.fillStyle = theme.lane;
    ctx.fillRect(0, lane.y, laneWidth, lane.height);
  }
  forEachVisible(lane.track.intervals, view, laneWidth, (from, to, isMerged) => {
    const inset = lane.kind === "contact" ? 2 : 0;
    if (isMerged)
      paintMerged(ctx, theme[lane.side], from, to, lane.y + inset, lane.height - 2 * inset);
    else if (inset)
      paintBracket(ctx, theme[lane.side], from, to - 1, lane.y + lane.height / 2, lane.height - 4);
    else paintBar(ctx, theme, lane, from, to, lane.y, lane.height);
  });
  paintEditedMarks(ctx, scene, lane, laneWidth);
  if (lane.kind === "contact") {
    paintWhiskers(ctx, scene, lane, laneWidth);
    paintPlantNumbers(ctx, scene, lane, laneWidth);
  } else {
    ctx.fillStyle = theme.uncertain;
    forEachVisible(lane.track.uncertain, view, laneWidth, (from, to, isMerged) => {
      // Merged ranges would cover whole bars.
      if (!isMerged) ctx.fillRect(from, lane.y + 2, Math.max(1, to - from), lane.height - 4);
    });
    if (lane.kind === "toe" && !scene.layout.lanes.some((other) => other.kind === "contact")) {
      paintPlantNumbers(ctx, scene, lane, laneWidth);
    }
  }
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
  // Early exit: plants without space for their numbers have none for whiskers.
  if (visible.length * minNumberWidth > laneWidth) return;
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
  const { view, theme, selected } = scene;
  if (selected?.side !== lane.side || selected.part !== lane.kind) return;
  const from = toX(view, selected.start, laneWidth);
  const to = Math.max(from + 3, toX(view, selected.end, laneWidth) - 1);
  const [top, height] = [lane.y - 1.5, lane.height + 3];
  ctx.beginPath();
  ctx.roundRect(from - 1.5, top, to - from + 3, height, 4);
  drawPath(ctx, theme.text, 1.5);
  ctx.fillStyle = theme.text;
  ctx.beginPath();
  for (const x of [from - 4, to]) ctx.roundRect(x, top, 4, height, 2);
  ctx.fill();
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

/** Draws the plant numbers on their bars. */
function paintPlantNumbers(
  ctx: CanvasRenderingContext2D,
  scene: Scene,
  lane: Bars,
  laneWidth: number,
) {
  const { view, theme } = scene;
  const visible = plantsWithin(scene.plants, lane.side, view);
  // Early exit: the shortest number already needs more space.
  if (0.6 * visible.length * minNumberWidth > laneWidth) return;
  ctx.font = font(10, 600);
  ctx.textAlign = "center";
  const centerY = lane.y + lane.height / 2;
  const fits = (plant: Plant) =>
    toX(view, plant.end, laneWidth) - toX(view, plant.start, laneWidth) >=
    ctx.measureText(String(plant.number)).width + 20;
  // Few numbers would look like missing plants, so either most are drawn or none.
  if (visible.filter(fits).length < 0.6 * visible.length) return;
  for (const plant of visible) {
    if (!fits(plant)) continue;
    const from = Math.max(0, toX(view, plant.start, laneWidth));
    const to = Math.min(laneWidth, toX(view, plant.end, laneWidth));
    const width = ctx.measureText(String(plant.number)).width + 8;
    if (to - from < width) continue;
    const x = (from + to) / 2;
    if (lane.kind === "contact") {
      ctx.fillStyle = theme.background;
      ctx.fillRect(x - width / 2, lane.y, width, lane.height);
      ctx.fillStyle = theme[lane.side];
    } else ctx.fillStyle = theme.textOnSide;
    ctx.fillText(String(plant.number), x, centerY + 0.5);
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
