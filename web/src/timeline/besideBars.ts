import type { Beside } from "../app/state";
import { eachInSight } from "../lib/crowd";
import { framesOf } from "../lib/inTime";
import { principal } from "../lib/plants";
import type { Side } from "../worker/types";
import { crowd } from "./bars";
import type { BesideBars } from "./layout";
import type { Scene } from "./scene";

const inTime = new WeakMap<Beside, { rate: number } & Record<Side, Uint32Array>>();

/** The plants of a clip beside ours in frames of ours. */
function plantsOf(beside: Beside, rate: number) {
  const held = inTime.get(beside);
  if (held?.rate === rate) return held;
  const tracks = principal(beside.detection?.parts ?? {});
  const side = (name: Side) =>
    framesOf(tracks?.[name].intervals ?? new Uint32Array(0), beside.clip.rate, rate);
  const made = { rate, left: side("left"), right: side("right") };
  inTime.set(beside, made);
  return made;
}

/** The plants of another clip at the same time: left over right. */
export function paintBeside(
  pen: CanvasRenderingContext2D,
  { view, ink, rate }: Scene,
  { beside, y, height }: BesideBars,
  inner: number,
) {
  const plants = plantsOf(beside, rate);
  const row = (height - 2) / 2;
  for (const side of ["left", "right"] as const) {
    const top = y + (side === "left" ? 0 : row + 2);
    pen.fillStyle = ink.lane;
    pen.fillRect(0, top, inner, row);
    eachInSight(plants[side], view, inner, (from, to, isCrowd) => {
      if (isCrowd) crowd(pen, ink[side], from, to, top, row);
      else {
        pen.fillStyle = ink[side];
        pen.fillRect(from, top, Math.max(1.5, to - from - 1), row);
      }
    });
  }
}
