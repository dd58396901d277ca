import { principalTracks } from "../model/plants";
import { retimeFrames } from "../model/retime";
import type { Companion } from "../model/source";
import type { Side } from "../model/types";
import { paintMerged } from "./bars";
import type { CompanionBars } from "./layout";
import type { Scene } from "./scene";
import { forEachVisible } from "./visible-intervals";

const inTime = new WeakMap<Companion, { rate: number } & Record<Side, Uint32Array>>();

/** The plants of a clip beside ours in frames of ours. */
function plantsOf(beside: Companion, rate: number) {
  const held = inTime.get(beside);
  if (held?.rate === rate) return held;
  const tracks = principalTracks(beside.detection?.parts ?? {});
  const side = (name: Side) =>
    retimeFrames(tracks?.[name].intervals ?? new Uint32Array(0), beside.clip.rate, rate);
  const made = { rate, left: side("left"), right: side("right") };
  inTime.set(beside, made);
  return made;
}

/** The plants of another clip at the same time: left over right. */
export function paintCompanion(
  pen: CanvasRenderingContext2D,
  { view, ink, rate }: Scene,
  { companion, y, height }: CompanionBars,
  inner: number,
) {
  const plants = plantsOf(companion, rate);
  const row = (height - 2) / 2;
  for (const side of ["left", "right"] as const) {
    const top = y + (side === "left" ? 0 : row + 2);
    pen.fillStyle = ink.lane;
    pen.fillRect(0, top, inner, row);
    forEachVisible(plants[side], view, inner, (from, to, isCrowd) => {
      if (isCrowd) paintMerged(pen, ink[side], from, to, top, row);
      else {
        pen.fillStyle = ink[side];
        pen.fillRect(from, top, Math.max(1.5, to - from - 1), row);
      }
    });
  }
}
