import { toX } from "../model/motion/time-view";
import { titleOfSource } from "../model/sources/source";
import { drawPath } from "../util/draw-path";
import { paintBar, paintBars, paintMerged } from "./bars";
import { paintCompanion } from "./companion-bars";
import { curveText, paintCurves, scaleText } from "./curves";
import { isBars, isCurves, type Lane } from "./layout";
import { paintReference, paintReferenceName } from "./reference-bars";
import { paintRuler } from "./ruler";
import { font, margin, type Scene } from "./scene";
import {
  paintMotifs,
  paintReferenceSegments,
  paintSegmentSwatch,
  paintSegments,
} from "./segment-bars";
import { paintSegmentationCurve } from "./segmentation-curve";
import { wrapText } from "./text";
import { forEachVisible } from "./visible-intervals";

const painters = {
  segments: paintSegments,
  motifs: paintMotifs,
  "reference-segments": paintReferenceSegments,
  curve: paintSegmentationCurve,
};

/** Draws the timeline without the playhead, which is a separate element. */
export function paintTimeline(ctx: CanvasRenderingContext2D, scene: Scene) {
  const { layout, theme, width } = scene;
  ctx.fillStyle = theme.background;
  ctx.fillRect(0, 0, width, layout.height);
  const laneWidth = width - layout.labelWidth - margin;
  ctx.textBaseline = "middle";
  for (const lane of layout.lanes) paintLabel(ctx, scene, lane);
  ctx.save();
  ctx.translate(layout.labelWidth, 0);
  paintRuler(ctx, scene, laneWidth);
  ctx.beginPath();
  ctx.rect(0, 0, laneWidth, layout.height);
  ctx.clip();
  for (const lane of layout.lanes) {
    if (isBars(lane)) paintBars(ctx, scene, lane, laneWidth);
    else if (isCurves(lane)) paintCurves(ctx, scene, lane, laneWidth);
    else if (lane.kind === "reference") paintReference(ctx, scene, lane, laneWidth);
    else if (lane.kind === "companion") paintCompanion(ctx, scene, lane, laneWidth);
    else painters[lane.kind](ctx, scene, lane, laneWidth);
  }
  paintMinimap(ctx, scene, laneWidth);
  ctx.restore();
}

/** Draws the label of a lane in the column on the left. */
function paintLabel(ctx: CanvasRenderingContext2D, scene: Scene, lane: Lane) {
  const { theme, layout } = scene;
  const centerY = lane.y + lane.height / 2 + 0.5;
  const left = layout.labelWidth > 100 ? 16 : 12;
  const right = layout.labelWidth - 6;
  ctx.textAlign = "left";
  ctx.font = font(12);
  ctx.fillStyle = theme.muted;
  if (isBars(lane)) {
    // The swatch serves as the legend of the bar textures.
    const height = Math.min(lane.height, 10);
    paintBar(ctx, theme, lane, left, left + 12, centerY - height / 2 - 0.5, height);
    const side = lane.side === "left" ? "L" : "R";
    ctx.font = font(lane.isPrincipal ? 12 : 10.5, lane.isPrincipal ? 550 : 450);
    ctx.fillStyle = lane.isPrincipal ? theme.text : theme.muted;
    ctx.fillText(`${side} ${lane.kind}`, left + 20, centerY);
  } else if (isCurves(lane)) {
    ctx.fillText(curveText(lane), left, centerY - 8);
    ctx.font = font(11);
    ctx.fillText(scaleText(lane, scene), left, centerY + 8);
  } else if (lane.kind === "reference") {
    paintReferenceName(ctx, theme, lane.name, lane, left + 20, right);
  } else if (lane.kind === "companion") {
    paintReferenceName(ctx, theme, titleOfSource(lane.companion.source), lane, left, right);
  } else if (lane.kind === "reference-segments") {
    paintReferenceName(ctx, theme, scene.referenceSegments?.name ?? "", lane, left + 20, right);
  } else if (lane.kind === "curve") {
    // The explanation in parentheses does not fit.
    const title = (scene.segmentation?.curve.title ?? "").replace(/ \(.*\)$/, "");
    const [first, second] = wrapText(ctx, theme, title, right - left, 11);
    ctx.fillText(first, left, second ? centerY - 7 : centerY);
    ctx.fillText(second, left, centerY + 7);
  } else {
    if (lane.kind === "segments") {
      paintSegmentSwatch(ctx, theme, left, centerY - 5);
      ctx.fillStyle = theme.text;
    }
    ctx.font = font(lane.kind === "motifs" ? 11 : 12);
    ctx.fillText(lane.kind === "motifs" ? "Motifs" : "Segments", left + 20, centerY);
  }
}

/** Draws the whole clip with a frame around the visible range. */
function paintMinimap(ctx: CanvasRenderingContext2D, scene: Scene, laneWidth: number) {
  const { theme, layout, tracks, frames, view } = scene;
  const { y, height } = layout.minimap;
  ctx.fillStyle = theme.lane;
  ctx.beginPath();
  ctx.roundRect(0, y, laneWidth, height, 3);
  ctx.fill();
  const whole = { start: 0, end: frames };
  const rowHeight = (height - 8) / 2;
  for (const side of tracks ? (["left", "right"] as const) : []) {
    forEachVisible(
      tracks?.[side].intervals as Uint32Array,
      whole,
      laneWidth,
      (from, to, isMerged) => {
        const top = y + 3 + (side === "left" ? 0 : rowHeight + 2);
        if (isMerged) paintMerged(ctx, theme[side], from, to, top, rowHeight);
        else {
          ctx.fillStyle = theme[side];
          ctx.fillRect(from, top, Math.max(1, to - from - 0.5), rowHeight);
        }
      },
    );
  }
  const from = toX(whole, view.start, laneWidth);
  const to = toX(whole, view.end, laneWidth);
  ctx.globalAlpha = 0.62;
  ctx.fillStyle = theme.background;
  ctx.fillRect(0, y, from, height);
  ctx.fillRect(to, y, laneWidth - to, height);
  ctx.globalAlpha = 1;
  ctx.beginPath();
  ctx.roundRect(from + 0.75, y + 0.75, Math.max(3, to - from - 1.5), height - 1.5, 3);
  drawPath(ctx, theme.text, 1.5);
  ctx.fillStyle = theme.text;
  for (const x of [from, to - 4]) {
    ctx.beginPath();
    ctx.roundRect(x, y + height / 2 - 5, 4, 10, 2);
    ctx.fill();
  }
}
