import { Color } from "three";

/** Colours of the style sheet for the three.js scene. */
export interface Palette {
  background: Color;
  floor: Color;
  grid: Color;
  muted: Color;
  bone: Color;
  joint: Color;
  left: Color;
  right: Color;
  accent: Color;
  /** The original in front of the cleaned clip. */
  difference: Color;
  /** Opacity of shadows. */
  shadow: number;
}

/** Reads the colours from the custom properties of an element. */
export function readPalette(from: Element): Palette {
  const style = getComputedStyle(from);
  const color = (name: string) => new Color().setStyle(style.getPropertyValue(name).trim());
  return {
    background: color("--view-background"),
    floor: color("--view-floor"),
    grid: color("--view-grid"),
    muted: color("--muted"),
    bone: color("--view-bone"),
    joint: color("--view-joint"),
    left: color("--left"),
    right: color("--right"),
    accent: color("--accent"),
    difference: color("--difference"),
    shadow: Number(style.getPropertyValue("--view-shadow")),
  };
}
