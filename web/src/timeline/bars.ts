import { type Plant, plantsWithin } from "../model/plants";
import { toX } from "../model/time-view";
import type { Track } from "../model/types";
import type { CanvasTheme } from "../ui/canvas-theme";
import type { Bars } from "./layout";
import { font, type Scene } from "./scene";
import { forEachVisible } from "./visible-intervals";

/** Pixels that the shortest number takes with what is left free around it. */
const leastRoom = 20;

const edits = new WeakMap<Track, Uint32Array>();

export function bracket(
  pen: CanvasRenderingContext2D,
  color: string,
  from: number,
  to: number,
  y: number,
  tall: number,
) {
  pen.fillStyle = color;
  const left = Math.round(from);
  const right = Math.max(left + 2, Math.round(to));
  pen.fillRect(left, y - tall / 2, 2, tall);
  pen.fillRect(right - 2, y - tall / 2, 2, tall);
  pen.fillRect(left, y - 1, right - left, 2);
}

export function bar(
  pen: CanvasRenderingContext2D,
  ink: CanvasTheme,
  lane: Bars,
  from: number,
  to: number,
  y: number,
  height: number,
) {
  const width = Math.max(1.5, to - from - 1);
  if (width <= 3) {
    // Too narrow for anything but its outline.
    pen.fillStyle = ink[lane.side];
    pen.fillRect(from, y, width, height);
    return;
  }
  pen.beginPath();
  pen.roundRect(from, y, width, height, Math.min(3, width / 2));
  if (lane.kind === "toe") {
    pen.fillStyle = ink[lane.side];
    pen.fill();
    return;
  }
  pen.fillStyle = ink.hatch[lane.side];
  pen.fill();
  pen.beginPath();
  pen.roundRect(
    from + 0.75,
    y + 0.75,
    Math.max(0.5, width - 1.5),
    height - 1.5,
    Math.min(2.5, width / 2),
  );
  pen.lineWidth = 1.5;
  pen.strokeStyle = ink[lane.side];
  pen.stroke();
}

export function paintBars(pen: CanvasRenderingContext2D, scene: Scene, lane: Bars, inner: number) {
  const { view, ink } = scene;
  if (lane.kind !== "contact") {
    pen.fillStyle = ink.lane;
    pen.fillRect(0, lane.y, inner, lane.height);
  }
  forEachVisible(lane.track.intervals, view, inner, (from, to, isCrowd) => {
    const inset = lane.kind === "contact" ? 2 : 0;
    if (isCrowd)
      paintMerged(pen, ink[lane.side], from, to, lane.y + inset, lane.height - 2 * inset);
    else if (inset)
      bracket(pen, ink[lane.side], from, to - 1, lane.y + lane.height / 2, lane.height - 4);
    else bar(pen, ink, lane, from, to, lane.y, lane.height);
  });
  markEdited(pen, scene, lane, inner);
  if (lane.kind === "contact") numberPlants(pen, scene, lane, inner);
  else {
    pen.fillStyle = ink.erode;
    forEachVisible(lane.track.uncertain, view, inner, (from, to, isCrowd) => {
      // From afar there is some doubt in every pixel.
      if (!isCrowd) pen.fillRect(from, lane.y + 2, Math.max(1, to - from), lane.height - 4);
    });
    if (lane.kind === "toe" && !scene.layout.lanes.some((other) => other.kind === "contact")) {
      numberPlants(pen, scene, lane, inner);
    }
  }
  outlineSelected(pen, scene, lane, inner);
}

/** Bars as a person wants them have a line along their foot. */
function markEdited(pen: CanvasRenderingContext2D, scene: Scene, lane: Bars, inner: number) {
  pen.fillStyle = scene.ink.text;
  forEachVisible(editedOf(lane.track), scene.view, inner, (from, to, isCrowd) => {
    // From afar one could not tell which.
    if (!isCrowd) pen.fillRect(from, lane.y + lane.height - 1.5, Math.max(2, to - from - 1), 2);
  });
}

/** The bar that is edited: a frame around it, with a handle at each end. */
function outlineSelected(pen: CanvasRenderingContext2D, scene: Scene, lane: Bars, inner: number) {
  const { view, ink, selected } = scene;
  if (selected?.side !== lane.side || selected.part !== lane.kind) return;
  const from = toX(view, selected.start, inner);
  const to = Math.max(from + 3, toX(view, selected.end, inner) - 1);
  const [top, height] = [lane.y - 1.5, lane.height + 3];
  pen.strokeStyle = ink.text;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.roundRect(from - 1.5, top, to - from + 3, height, 4);
  pen.stroke();
  pen.fillStyle = ink.text;
  pen.beginPath();
  for (const x of [from - 4, to]) pen.roundRect(x, top, 4, height, 2);
  pen.fill();
}

/** Plants from too far to be told apart: paler than one that is as long. */
export function paintMerged(
  pen: CanvasRenderingContext2D,
  color: string,
  from: number,
  to: number,
  y: number,
  height: number,
) {
  pen.globalAlpha = 0.4;
  pen.fillStyle = color;
  pen.fillRect(from, y, to - from, height);
  pen.globalAlpha = 1;
}

function numberPlants(pen: CanvasRenderingContext2D, scene: Scene, lane: Bars, inner: number) {
  const { view, ink } = scene;
  const seen = plantsWithin(scene.plants, lane.side, view);
  // Without looking at each: no number needs less than that.
  if (0.6 * seen.length * leastRoom > inner) return;
  pen.font = font(10, 600);
  pen.textAlign = "center";
  const middle = lane.y + lane.height / 2;
  const fits = (plant: Plant) =>
    toX(view, plant.end, inner) - toX(view, plant.start, inner) >=
    pen.measureText(String(plant.number)).width + 20;
  // A number here and there would look like a gap in the count: most of them, or none.
  if (seen.filter(fits).length < 0.6 * seen.length) return;
  for (const plant of seen) {
    if (!fits(plant)) continue;
    const from = Math.max(0, toX(view, plant.start, inner));
    const to = Math.min(inner, toX(view, plant.end, inner));
    const width = pen.measureText(String(plant.number)).width + 8;
    if (to - from < width) continue;
    const x = (from + to) / 2;
    if (lane.kind === "contact") {
      pen.fillStyle = ink.ground;
      pen.fillRect(x - width / 2, lane.y, width, lane.height);
      pen.fillStyle = ink[lane.side];
    } else pen.fillStyle = ink.onSide;
    pen.fillText(String(plant.number), x, middle + 0.5);
  }
}

function editedOf(track: Track): Uint32Array {
  let held = edits.get(track);
  if (!held) {
    held = track.intervals.filter((_, i) => track.edited[i >> 1] === 1);
    edits.set(track, held);
  }
  return held;
}
