import type { CanvasTheme } from "../ui/canvas-theme";
import { font } from "./scene";

interface Known {
  /** Width of the first characters for each number of them, and that of the dots for the rest. */
  widths: Float32Array;
  count: number;
  shown: string;
}

/** What was measured, as long as the typeface is the same: a timeline draws it many times a second. */
const known = new WeakMap<CanvasTheme, Map<string, Known>>();

function look(pen: CanvasRenderingContext2D, ink: CanvasTheme, text: string, size: number): Known {
  pen.font = font(size);
  let texts = known.get(ink);
  if (!texts || texts.size > 4000) {
    texts = new Map();
    known.set(ink, texts);
  }
  const key = `${size} ${text}`;
  let held = texts.get(key);
  if (!held) {
    const widths = new Float32Array(text.length + 2);
    for (let i = 1; i <= text.length; i++) widths[i] = pen.measureText(text.slice(0, i)).width;
    widths[text.length + 1] = pen.measureText("…").width;
    held = { widths, count: text.length, shown: text };
    texts.set(key, held);
  }
  return held;
}

/** The width of a text; the pen is set to its typeface. */
export function widthOf(
  pen: CanvasRenderingContext2D,
  ink: CanvasTheme,
  text: string,
  size: number,
) {
  return look(pen, ink, text, size).widths[text.length] as number;
}

/** A text cut to a width, with `…` for what is missing; empty where nothing fits. */
export function fitted(
  pen: CanvasRenderingContext2D,
  ink: CanvasTheme,
  text: string,
  room: number,
  size: number,
): string {
  const held = look(pen, ink, text, size);
  const { widths } = held;
  let count = text.length;
  if ((widths[count] as number) > room) {
    const dots = widths[count + 1] as number;
    while (count > 0 && (widths[count] as number) + dots > room) count--;
    // Half of a character that counts twice is none.
    if (/[\ud800-\udbff]/.test(text.charAt(count - 1))) count--;
  }
  if (count !== held.count) {
    held.count = count;
    held.shown =
      count === text.length ? text : count > 0 ? `${text.slice(0, count).trimEnd()}…` : "";
  }
  return held.shown;
}

/** Two lines of a text, broken between words; the second is cut where it is too long. */
export function twoLines(
  pen: CanvasRenderingContext2D,
  ink: CanvasTheme,
  text: string,
  room: number,
  size: number,
): readonly [string, string] {
  let at = text.length;
  while (at > 0 && widthOf(pen, ink, text.slice(0, at), size) > room)
    at = text.lastIndexOf(" ", at - 1);
  if (at <= 0) return [fitted(pen, ink, text, room, size), ""];
  return [text.slice(0, at), fitted(pen, ink, text.slice(at + 1), room, size)];
}
