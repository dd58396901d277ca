import type { Side } from "../model/types";

/** The page's colours as the canvas needs them, with the patterns made of them. */
export interface CanvasTheme {
  ground: string;
  lane: string;
  line: string;
  edge: string;
  raised: string;
  accent: string;
  muted: string;
  text: string;
  left: string;
  right: string;
  onSide: string;
  tint: Record<Side, string>;
  hatch: Record<Side, CanvasPattern | string>;
  unknown: CanvasPattern | string;
  erode: CanvasPattern | string;
  transition: CanvasPattern | string;
}

export function readCanvasTheme(
  from: Element,
  pen: CanvasRenderingContext2D,
  ratio: number,
): CanvasTheme {
  const style = getComputedStyle(from);
  const color = (name: string) => style.getPropertyValue(name).trim();
  const [left, right, ground] = [color("--left"), color("--right"), color("--panel")];
  return {
    ground,
    lane: color("--lane"),
    line: color("--border"),
    edge: color("--border-strong"),
    raised: color("--raised"),
    accent: color("--accent"),
    muted: color("--muted"),
    text: color("--text"),
    left,
    right,
    onSide: color("--text-on-side"),
    tint: { left: color("--left-tint"), right: color("--right-tint") },
    unknown: hatch(pen, color("--border-strong"), ratio),
    hatch: { left: hatch(pen, left, ratio), right: hatch(pen, right, ratio) },
    transition: hatch(pen, color("--muted"), ratio),
    erode: dots(pen, ground, ratio),
  };
}

function pattern(
  pen: CanvasRenderingContext2D,
  size: number,
  ratio: number,
  paint: (p: CanvasRenderingContext2D) => void,
): CanvasPattern | undefined {
  const tile = document.createElement("canvas");
  tile.width = Math.round(size * ratio);
  tile.height = tile.width;
  const p = tile.getContext("2d");
  if (!p) return undefined;
  p.scale(tile.width / size, tile.width / size);
  paint(p);
  const made = pen.createPattern(tile, "repeat");
  made?.setTransform(new DOMMatrix().scale(size / tile.width));
  return made ?? undefined;
}

/** Diagonal strokes: the heel's texture. */
function hatch(pen: CanvasRenderingContext2D, color: string, ratio: number) {
  const made = pattern(pen, 6, ratio, (p) => {
    p.strokeStyle = color;
    p.lineWidth = 1.6;
    p.beginPath();
    for (const x of [-6, 0, 6]) {
      p.moveTo(x - 1, 7);
      p.lineTo(x + 7, -1);
    }
    p.stroke();
  });
  return made ?? color;
}

/** Holes in the colour of the ground: doubt eats into a bar. */
function dots(pen: CanvasRenderingContext2D, ground: string, ratio: number) {
  const made = pattern(pen, 4, ratio, (p) => {
    p.fillStyle = ground;
    for (const [x, y] of [
      [1, 1],
      [3, 3],
    ] as const) {
      p.beginPath();
      p.arc(x, y, 0.95, 0, 7);
      p.fill();
    }
  });
  return made ?? "transparent";
}
