import { rangesWhere } from "../model/intervals";
import type { CanvasTheme } from "../ui/canvas-theme";
import type { ReferenceBars } from "./layout";
import type { Scene } from "./scene";
import { fitted } from "./text";
import { forEachVisible } from "./visible-intervals";

interface Found {
  planted: Uint32Array;
  unknown: Uint32Array;
}

const found = new WeakMap<Int8Array, Found>();

function runsOf(labels: Int8Array): Found {
  let held = found.get(labels);
  if (!held) {
    held = {
      planted: rangesWhere(labels.length, (i) => labels[i] === 1),
      unknown: rangesWhere(labels.length, (i) => labels[i] === -1),
    };
    found.set(labels, held);
  }
  return held;
}

/** Someone else's plants: outlines of ours, so that nobody takes one for the other. */
export function paintReference(
  pen: CanvasRenderingContext2D,
  { view, ink }: Scene,
  lane: ReferenceBars,
  inner: number,
) {
  const { planted, unknown } = runsOf(lane.labels);
  const each = (intervals: Uint32Array, draw: (x: number, width: number) => void) =>
    forEachVisible(intervals, view, inner, (from, to) => draw(from, Math.max(2, to - from - 1)));
  pen.fillStyle = ink.unknown;
  each(unknown, (x, width) => pen.fillRect(x, lane.y + 2, width, lane.height - 4));
  pen.fillStyle = ink.tint[lane.side];
  pen.strokeStyle = ink[lane.side];
  pen.lineWidth = 1;
  each(planted, (x, width) => {
    pen.beginPath();
    pen.roundRect(x + 0.5, lane.y + 0.5, Math.max(1, width - 1), lane.height - 1, 2);
    pen.fill();
    pen.stroke();
  });
}

/** The name of the labels beside their lane, cut where it meets the lane. */
export function paintReferenceName(
  pen: CanvasRenderingContext2D,
  ink: CanvasTheme,
  name: string,
  { y, height }: { y: number; height: number },
  left: number,
  right: number,
) {
  const shown = fitted(pen, ink, name.replace(/\.(json|csv|bvh)$/i, ""), right - left, 10);
  pen.fillStyle = ink.muted;
  pen.fillText(shown, left, y + height / 2 + 0.5);
}
