import type uPlot from "uplot";
import { sides } from "../model/plants/evidence";
import type { Side } from "../model/types";
import type { PointedFrame } from "../store/evidence";
import type { CanvasTheme } from "../ui/canvas-theme";
import { drawPath } from "../util/draw-path";
import type { PlotData, PlotSpec } from "./plot-data";

/** Width of the margin around the plot for markers at its edge, in pixels. */
const overflow = 10;

/** Least distance between the markers of both feet, in pixels. */
const minSpacing = 15;

/** Number of frames before and after the playhead for which the trail is drawn. */
const trailFrames = 12;

export type Markers = ReturnType<typeof createMarkers>;

/**
 * Creates the markers of both feet at the playhead and at the pointed frame. They are drawn on a
 * separate canvas, so that playback does not redraw the plot.
 */
export function createMarkers(plot: uPlot, spec: PlotSpec, themeOf: () => CanvasTheme) {
  const canvas = document.createElement("canvas");
  canvas.className = "plot-markers";
  plot.over.append(canvas);
  const ctx = canvas.getContext("2d") as CanvasRenderingContext2D;
  let request = 0;
  let paint = () => {};
  const requestDraw = () => {
    request ||= requestAnimationFrame(() => {
      request = 0;
      paint();
    });
  };
  const clear = () => {
    const pixelRatio = devicePixelRatio;
    const [cssWidth, cssHeight] = [plot.over.clientWidth, plot.over.clientHeight];
    const [width, height] = [cssWidth, cssHeight].map((size) =>
      Math.round((size + 2 * overflow) * pixelRatio),
    );
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width ?? 0;
      canvas.height = height ?? 0;
    }
    ctx.setTransform(pixelRatio, 0, 0, pixelRatio, overflow * pixelRatio, overflow * pixelRatio);
    ctx.clearRect(-overflow, -overflow, cssWidth + 2 * overflow, cssHeight + 2 * overflow);
  };
  return {
    update(plotData: PlotData, playheadFrame: number, pointed: PointedFrame | null) {
      paint = () => {
        clear();
        const theme = themeOf();
        const positionOf = (side: Side, frame: number) => {
          const value = plotData.position({ side, frame });
          return value && { x: plot.valToPos(value.x, "x"), y: plot.valToPos(value.y, "y") };
        };
        if (spec.hasSqrtAxes) {
          for (const side of sides)
            paintTrail(ctx, theme[side], playheadFrame, (trailFrame) =>
              positionOf(side, trailFrame),
            );
        }
        const [left, right] = separate(
          positionOf("left", playheadFrame),
          positionOf("right", playheadFrame),
        );
        if (left) paintFoot(ctx, theme, "left", left);
        if (right) paintFoot(ctx, theme, "right", right);
        for (const side of pointed ? sides : []) {
          const position = positionOf(side, pointed?.frame ?? 0);
          if (position) paintPointed(ctx, theme, side, position, pointed?.side === side);
        }
      };
      requestDraw();
    },
    redraw: requestDraw,
    dispose: () => cancelAnimationFrame(request),
  };
}

interface Position {
  x: number;
  y: number;
}

/** Moves overlapping markers apart horizontally. */
function separate(left?: Position, right?: Position): [Position | undefined, Position | undefined] {
  if (!left || !right) return [left, right];
  const distance = Math.hypot(left.x - right.x, left.y - right.y);
  if (distance >= minSpacing) return [left, right];
  const shift = ((minSpacing - distance) / 2) * (left.x <= right.x ? 1 : -1);
  return [
    { ...left, x: left.x - shift },
    { ...right, x: right.x + shift },
  ];
}

/** Draws the trail of a foot around the playhead. */
function paintTrail(
  ctx: CanvasRenderingContext2D,
  color: string,
  playheadFrame: number,
  positionOf: (frame: number) => Position | undefined,
) {
  ctx.lineJoin = "round";
  ctx.globalAlpha = 0.8;
  ctx.beginPath();
  for (
    let trailFrame = Math.max(0, playheadFrame - trailFrames);
    trailFrame <= playheadFrame + trailFrames;
    trailFrame++
  ) {
    const position = positionOf(trailFrame);
    if (position) ctx.lineTo(position.x, position.y);
  }
  drawPath(ctx, color, 1.25);
  ctx.globalAlpha = 1;
}

/** Draws the marker of a foot at the playhead, with the letter of its side. */
function paintFoot(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  side: Side,
  { x, y }: Position,
) {
  fillCircle(ctx, x, y, 8.5, theme.background);
  fillCircle(ctx, x, y, 7, theme[side]);
  ctx.fillStyle = theme.textOnSide;
  ctx.font = '700 9px "Inter Variable", system-ui, sans-serif';
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.fillText(side === "left" ? "L" : "R", x, y + 0.5);
}

/** Draws a foot at the pointed frame, emphasised if its point is the nearest to the pointer. */
function paintPointed(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  side: Side,
  { x, y }: Position,
  isNearest: boolean,
) {
  if (isNearest) fillCircle(ctx, x, y, 4, theme[side]);
  ctx.beginPath();
  ctx.arc(x, y, isNearest ? 7 : 5, 0, 7);
  drawPath(ctx, theme.background, 4);
  drawPath(ctx, theme.accent, 2);
}

function fillCircle(
  ctx: CanvasRenderingContext2D,
  x: number,
  y: number,
  radius: number,
  color: string,
) {
  ctx.fillStyle = color;
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 7);
  ctx.fill();
}
