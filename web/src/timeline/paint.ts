import { toX } from "../model/time-view";
import type { CanvasTheme } from "../ui/canvas-theme";
import { bar, bracket, paintBars, paintMerged } from "./bars";
import { paintCompanion } from "./companion-bars";
import { curveText, paintCurves, scaleText } from "./curves";
import { type Bars, isBars, isCurves, type Lane } from "./layout";
import { paintReference, paintReferenceName } from "./reference-bars";
import { paintRuler } from "./ruler";
import { font, margin, type Scene } from "./scene";
import { paintMotifs, paintReferenceSegments, paintSegments, segmentSwatch } from "./segment-bars";
import { paintSegmentationCurve } from "./segmentation-curve";
import { twoLines } from "./text";
import { forEachVisible } from "./visible-intervals";

const painters = {
  segments: paintSegments,
  motifs: paintMotifs,
  "reference-segments": paintReferenceSegments,
  curve: paintSegmentationCurve,
};

/** Draws everything but the playhead, which is an element of its own. */
export function paint(pen: CanvasRenderingContext2D, scene: Scene) {
  const { layout, ink, width } = scene;
  pen.fillStyle = ink.ground;
  pen.fillRect(0, 0, width, layout.height);
  const inner = width - layout.labels - margin;
  pen.textBaseline = "middle";
  for (const lane of layout.lanes) paintLabel(pen, scene, lane);
  pen.save();
  pen.translate(layout.labels, 0);
  paintRuler(pen, scene, inner);
  pen.beginPath();
  pen.rect(0, 0, inner, layout.height);
  pen.clip();
  for (const lane of layout.lanes) {
    if (isBars(lane)) paintBars(pen, scene, lane, inner);
    else if (isCurves(lane)) paintCurves(pen, scene, lane, inner);
    else if (lane.kind === "reference") paintReference(pen, scene, lane, inner);
    else if (lane.kind === "companion") paintCompanion(pen, scene, lane, inner);
    else painters[lane.kind](pen, scene, lane, inner);
  }
  paintMinimap(pen, scene, inner);
  pen.restore();
}

function paintLabel(pen: CanvasRenderingContext2D, scene: Scene, lane: Lane) {
  const { ink, layout } = scene;
  const middle = lane.y + lane.height / 2 + 0.5;
  const left = layout.labels > 100 ? 16 : 12;
  const right = layout.labels - 6;
  pen.textAlign = "left";
  pen.font = font(12);
  pen.fillStyle = ink.muted;
  if (isBars(lane)) {
    // The swatch repeats the texture of the bar: a legend that needs no room.
    swatch(pen, ink, lane, left, middle - 5);
    pen.fillStyle = lane.kind === "contact" ? ink.text : ink.muted;
    pen.fillText(`${lane.side === "left" ? "L" : "R"} ${lane.kind}`, left + 20, middle);
  } else if (isCurves(lane)) {
    pen.fillText(curveText(lane), left, middle - 8);
    pen.font = font(11);
    pen.fillText(scaleText(lane), left, middle + 8);
  } else if (lane.kind === "reference") {
    paintReferenceName(pen, ink, lane.name, lane, left + 20, right);
  } else if (lane.kind === "companion") {
    paintReferenceName(pen, ink, lane.companion.source.name, lane, left, right);
  } else if (lane.kind === "reference-segments") {
    paintReferenceName(pen, ink, scene.referenceSegments?.name ?? "", lane, left + 20, right);
  } else if (lane.kind === "curve") {
    const title = scene.segmentation?.curve.title ?? "";
    const [first, second] = twoLines(pen, ink, title, right - left, 11);
    pen.fillText(first, left, second ? middle - 7 : middle);
    pen.fillText(second, left, middle + 7);
  } else {
    if (lane.kind === "segments") {
      segmentSwatch(pen, ink, left, middle - 5);
      pen.fillStyle = ink.text;
    }
    pen.font = font(lane.kind === "motifs" ? 11 : 12);
    pen.fillText(lane.kind === "motifs" ? "Motifs" : "Segments", left + 20, middle);
  }
}

function swatch(pen: CanvasRenderingContext2D, ink: CanvasTheme, lane: Bars, x: number, y: number) {
  if (lane.kind === "contact") bracket(pen, ink[lane.side], x, x + 12, y + 5, 8);
  else bar(pen, ink, lane, x, x + 12, y, 10);
}

function paintMinimap(pen: CanvasRenderingContext2D, scene: Scene, inner: number) {
  const { ink, layout, tracks, frames, view } = scene;
  const { y, height } = layout.minimap;
  pen.fillStyle = ink.lane;
  pen.beginPath();
  pen.roundRect(0, y, inner, height, 3);
  pen.fill();
  const whole = { start: 0, end: frames };
  const row = (height - 8) / 2;
  for (const side of tracks ? (["left", "right"] as const) : []) {
    forEachVisible(tracks?.[side].intervals as Uint32Array, whole, inner, (from, to, isCrowd) => {
      const top = y + 3 + (side === "left" ? 0 : row + 2);
      if (isCrowd) paintMerged(pen, ink[side], from, to, top, row);
      else {
        pen.fillStyle = ink[side];
        pen.fillRect(from, top, Math.max(1, to - from - 0.5), row);
      }
    });
  }
  const from = toX(whole, view.start, inner);
  const to = toX(whole, view.end, inner);
  pen.globalAlpha = 0.62;
  pen.fillStyle = ink.ground;
  pen.fillRect(0, y, from, height);
  pen.fillRect(to, y, inner - to, height);
  pen.globalAlpha = 1;
  pen.strokeStyle = ink.text;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.roundRect(from + 0.75, y + 0.75, Math.max(3, to - from - 1.5), height - 1.5, 3);
  pen.stroke();
  pen.fillStyle = ink.text;
  for (const x of [from, to - 4]) {
    pen.beginPath();
    pen.roundRect(x, y + height / 2 - 5, 4, 10, 2);
    pen.fill();
  }
}
