import { retimeFrames } from "../model/motion/retime";
import { principalTracks } from "../model/plants/plants";
import type { Companion } from "../model/sources/source";
import type { Side } from "../model/types";
import { paintMerged } from "./bars";
import type { CompanionBars } from "./layout";
import type { Scene } from "./scene";
import { forEachVisible } from "./visible-intervals";

/** Cache of `plantsInMainRate`. */
const retimedPlants = new WeakMap<Companion, { rate: number } & Record<Side, Uint32Array>>();

/** Returns the plants of a comparison clip, converted to the frame rate of the open clip. */
function plantsInMainRate(companion: Companion, rate: number) {
  const cached = retimedPlants.get(companion);
  if (cached?.rate === rate) return cached;
  const tracks = principalTracks(companion.detection?.parts ?? {});
  const side = (name: Side) =>
    retimeFrames(tracks?.[name].intervals ?? new Uint32Array(0), companion.clip.rate, rate);
  const result = { rate, left: side("left"), right: side("right") };
  retimedPlants.set(companion, result);
  return result;
}

/** Draws the plants of a comparison clip in two rows: left above right. */
export function paintCompanion(
  ctx: CanvasRenderingContext2D,
  { view, theme, rate }: Scene,
  { companion, y, height }: CompanionBars,
  laneWidth: number,
) {
  const plants = plantsInMainRate(companion, rate);
  const rowHeight = (height - 2) / 2;
  for (const side of ["left", "right"] as const) {
    const top = y + (side === "left" ? 0 : rowHeight + 2);
    ctx.fillStyle = theme.lane;
    ctx.fillRect(0, top, laneWidth, rowHeight);
    forEachVisible(plants[side], view, laneWidth, (from, to, isMerged) => {
      if (isMerged) paintMerged(ctx, theme[side], from, to, top, rowHeight);
      else {
        ctx.fillStyle = theme[side];
        ctx.fillRect(from, top, Math.max(1.5, to - from - 1), rowHeight);
      }
    });
  }
}
