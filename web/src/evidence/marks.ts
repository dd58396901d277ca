import type uPlot from "uplot";
import { sides } from "../model/evidence";
import type { Side } from "../model/types";
import type { PointedFrame } from "../store/evidence";
import type { CanvasTheme } from "../ui/canvas-theme";
import type { PlotData, PlotSpec } from "./plot-data";

/** Room around the plot for marks that stand on its edge. */
const beyond = 10;

/** Least distance of the marks of both feet. */
const least = 15;

/** Frames to either side whose way through the plot is drawn. */
const trail = 12;

export type Marks = ReturnType<typeof createMarks>;

/** The feet at the playhead and those pointed at, on a canvas of their own: playing repaints no plot. */
export function createMarks(plot: uPlot, frame: PlotSpec, inkOf: () => CanvasTheme) {
  const canvas = document.createElement("canvas");
  canvas.className = "plot-markers";
  plot.over.append(canvas);
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  let due = 0;
  let paint = () => {};
  const draw = () => {
    due ||= requestAnimationFrame(() => {
      due = 0;
      paint();
    });
  };
  const clear = () => {
    const ratio = devicePixelRatio;
    const [wide, high] = [plot.over.clientWidth, plot.over.clientHeight];
    const [width, height] = [wide, high].map((size) => Math.round((size + 2 * beyond) * ratio));
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width ?? 0;
      canvas.height = height ?? 0;
    }
    pen.setTransform(ratio, 0, 0, ratio, beyond * ratio, beyond * ratio);
    pen.clearRect(-beyond, -beyond, wide + 2 * beyond, high + 2 * beyond);
  };
  return {
    show(picture: PlotData, at: number, point: PointedFrame | null) {
      paint = () => {
        clear();
        const ink = inkOf();
        const place = (side: Side, frame: number) => {
          const found = picture.place({ side, frame });
          return found && { x: plot.valToPos(found.x, "x"), y: plot.valToPos(found.y, "y") };
        };
        if (frame.square) {
          for (const side of sides) path(pen, ink[side], at, (near) => place(side, near));
        }
        const [left, right] = apart(place("left", at), place("right", at));
        if (left) dot(pen, ink, "left", left);
        if (right) dot(pen, ink, "right", right);
        for (const side of point ? sides : []) {
          const here = place(side, point?.frame ?? 0);
          if (here) ring(pen, ink, side, here, point?.side === side);
        }
      };
      draw();
    },
    draw,
    end: () => cancelAnimationFrame(due),
  };
}

interface Spot {
  x: number;
  y: number;
}

/** Marks of feet that are alike stand side by side, or one would hide the other. */
function apart(left?: Spot, right?: Spot): [Spot | undefined, Spot | undefined] {
  if (!left || !right) return [left, right];
  const off = Math.hypot(left.x - right.x, left.y - right.y);
  if (off >= least) return [left, right];
  const by = ((least - off) / 2) * (left.x <= right.x ? 1 : -1);
  return [
    { ...left, x: left.x - by },
    { ...right, x: right.x + by },
  ];
}

/** The way of a foot a moment before and after. */
function path(
  pen: CanvasRenderingContext2D,
  color: string,
  at: number,
  place: (frame: number) => Spot | undefined,
) {
  pen.strokeStyle = color;
  pen.lineWidth = 1.25;
  pen.lineJoin = "round";
  pen.globalAlpha = 0.8;
  pen.beginPath();
  for (let near = Math.max(0, at - trail); near <= at + trail; near++) {
    const spot = place(near);
    if (spot) pen.lineTo(spot.x, spot.y);
  }
  pen.stroke();
  pen.globalAlpha = 1;
}

/** A foot at the playhead, with its letter: colour alone says nothing. */
function dot(pen: CanvasRenderingContext2D, ink: CanvasTheme, side: Side, { x, y }: Spot) {
  disc(pen, x, y, 8.5, ink.ground);
  disc(pen, x, y, 7, ink[side]);
  pen.fillStyle = ink.onSide;
  pen.font = '700 9px "Inter Variable", system-ui, sans-serif';
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(side === "left" ? "L" : "R", x, y + 0.5);
}

/** A foot pointed at: the one whose point it is stands out. */
function ring(
  pen: CanvasRenderingContext2D,
  ink: CanvasTheme,
  side: Side,
  { x, y }: Spot,
  own: boolean,
) {
  if (own) disc(pen, x, y, 4, ink[side]);
  pen.strokeStyle = ink.ground;
  pen.lineWidth = 4;
  pen.beginPath();
  pen.arc(x, y, own ? 7 : 5, 0, 7);
  pen.stroke();
  pen.strokeStyle = ink.accent;
  pen.lineWidth = 2;
  pen.stroke();
}

function disc(pen: CanvasRenderingContext2D, x: number, y: number, radius: number, color: string) {
  pen.fillStyle = color;
  pen.beginPath();
  pen.arc(x, y, radius, 0, 7);
  pen.fill();
}
