import type { CanvasTheme } from "../ui/canvas-theme";
import { font } from "./scene";

interface MeasuredText {
  /** Width of the first i characters at index i; the last entry is the width of the ellipsis. */
  widths: Float32Array;
  /** Number of characters of the text in `truncated`. */
  count: number;
  /** The text as it was last truncated. */
  truncated: string;
}

/** Measured texts by font size and text. A new theme, as after loading the font, has a new cache. */
const cache = new WeakMap<CanvasTheme, Map<string, MeasuredText>>();

/** Measures a text and sets the font of the context. */
function measure(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  text: string,
  size: number,
): MeasuredText {
  ctx.font = font(size);
  let texts = cache.get(theme);
  if (!texts || texts.size > 4000) {
    texts = new Map();
    cache.set(theme, texts);
  }
  const key = `${size} ${text}`;
  let measured = texts.get(key);
  if (!measured) {
    const widths = new Float32Array(text.length + 2);
    for (let i = 1; i <= text.length; i++) widths[i] = ctx.measureText(text.slice(0, i)).width;
    widths[text.length + 1] = ctx.measureText("…").width;
    measured = { widths, count: text.length, truncated: text };
    texts.set(key, measured);
  }
  return measured;
}

/** Returns the width of a text in pixels, and sets the font of the context. */
export function textWidth(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  text: string,
  size: number,
) {
  return measure(ctx, theme, text, size).widths[text.length] as number;
}

/** Returns a text truncated to a width, with an ellipsis; empty if nothing fits. */
export function truncateText(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  text: string,
  maxWidth: number,
  size: number,
): string {
  const measured = measure(ctx, theme, text, size);
  const { widths } = measured;
  let count = text.length;
  if ((widths[count] as number) > maxWidth) {
    const ellipsisWidth = widths[count + 1] as number;
    while (count > 0 && (widths[count] as number) + ellipsisWidth > maxWidth) count--;
    // Surrogate pairs are not split.
    if (/[\ud800-\udbff]/.test(text.charAt(count - 1))) count--;
  }
  if (count !== measured.count) {
    measured.count = count;
    measured.truncated =
      count === text.length ? text : count > 0 ? `${text.slice(0, count).trimEnd()}…` : "";
  }
  return measured.truncated;
}

/** Returns two lines of a text, broken between words; the second is truncated if necessary. */
export function wrapText(
  ctx: CanvasRenderingContext2D,
  theme: CanvasTheme,
  text: string,
  maxWidth: number,
  size: number,
): readonly [string, string] {
  let breakIndex = text.length;
  while (breakIndex > 0 && textWidth(ctx, theme, text.slice(0, breakIndex), size) > maxWidth)
    breakIndex = text.lastIndexOf(" ", breakIndex - 1);
  if (breakIndex <= 0) return [truncateText(ctx, theme, text, maxWidth, size), ""];
  return [
    text.slice(0, breakIndex),
    truncateText(ctx, theme, text.slice(breakIndex + 1), maxWidth, size),
  ];
}
