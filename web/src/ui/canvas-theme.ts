import type { Side } from "../model/types";
import { drawPath } from "../util/draw-path";

/** Colours of the style sheet and fill patterns for drawing on a canvas. */
export interface CanvasTheme {
  background: string;
  lane: string;
  border: string;
  borderStrong: string;
  raised: string;
  /** Thresholds and the frame under the pointer. */
  accent: string;
  muted: string;
  text: string;
  left: string;
  right: string;
  /** Frames in which labels differ from the reference. */
  difference: string;
  /** Text on the colour of a side. */
  textOnSide: string;
  tint: Record<Side, string>;
  /** Heel contact. */
  hatch: Record<Side, CanvasPattern | string>;
  /** Frames without a reference label. */
  unknown: CanvasPattern | string;
  /** Frames of low confidence; drawn over a bar. */
  uncertain: CanvasPattern | string;
  /** Transitions between segments. */
  transition: CanvasPattern | string;
}

/** Reads the colours from the custom properties of an element; `pixelRatio` is device pixels per CSS pixel. */
export function readCanvasTheme(
  element: Element,
  ctx: CanvasRenderingContext2D,
  pixelRatio: number,
): CanvasTheme {
  const style = getComputedStyle(element);
  const color = (name: string) => style.getPropertyValue(name).trim();
  const [left, right, background] = [color("--left"), color("--right"), color("--panel")];
  return {
    background,
    lane: color("--lane"),
    border: color("--border"),
    borderStrong: color("--border-strong"),
    raised: color("--raised"),
    accent: color("--accent"),
    muted: color("--muted"),
    text: color("--text"),
    left,
    right,
    difference: color("--difference"),
    textOnSide: color("--text-on-side"),
    tint: { left: color("--left-tint"), right: color("--right-tint") },
    unknown: createHatch(ctx, color("--border-strong"), pixelRatio),
    hatch: { left: createHatch(ctx, left, pixelRatio), right: createHatch(ctx, right, pixelRatio) },
    transition: createHatch(ctx, color("--muted"), pixelRatio),
    uncertain: createDots(ctx, background, pixelRatio),
  };
}

/** Returns a repeating pattern of a square tile, or undefined without a canvas. */
function createPattern(
  ctx: CanvasRenderingContext2D,
  size: number,
  pixelRatio: number,
  draw: (tileCtx: CanvasRenderingContext2D) => void,
): CanvasPattern | undefined {
  const tile = document.createElement("canvas");
  tile.width = Math.round(size * pixelRatio);
  tile.height = tile.width;
  const tileCtx = tile.getContext("2d");
  if (!tileCtx) return undefined;
  tileCtx.scale(tile.width / size, tile.width / size);
  draw(tileCtx);
  const pattern = ctx.createPattern(tile, "repeat");
  pattern?.setTransform(new DOMMatrix().scale(size / tile.width));
  return pattern ?? undefined;
}

/** Returns a pattern of diagonal lines, or the plain colour without a canvas. */
function createHatch(ctx: CanvasRenderingContext2D, color: string, pixelRatio: number) {
  const pattern = createPattern(ctx, 6, pixelRatio, (tileCtx) => {
    tileCtx.beginPath();
    for (const x of [-6, 0, 6]) {
      tileCtx.moveTo(x - 1, 7);
      tileCtx.lineTo(x + 7, -1);
    }
    drawPath(tileCtx, color, 1.6);
  });
  return pattern ?? color;
}

/** Returns a pattern of dots in the background colour, which look like holes in a bar. */
function createDots(ctx: CanvasRenderingContext2D, background: string, pixelRatio: number) {
  const pattern = createPattern(ctx, 4, pixelRatio, (tileCtx) => {
    tileCtx.fillStyle = background;
    for (const [x, y] of [
      [1, 1],
      [3, 3],
    ] as const) {
      tileCtx.beginPath();
      tileCtx.arc(x, y, 0.95, 0, 7);
      tileCtx.fill();
    }
  });
  return pattern ?? "transparent";
}
