import { Color } from "three";

/** The page's colours as the scene needs them. */
export interface Palette {
  ground: Color;
  floor: Color;
  line: Color;
  muted: Color;
  bone: Color;
  joint: Color;
  left: Color;
  right: Color;
  shadow: number;
}

export function readPalette(from: Element): Palette {
  const style = getComputedStyle(from);
  const color = (name: string) => new Color().setStyle(style.getPropertyValue(name).trim());
  return {
    ground: color("--view-background"),
    floor: color("--view-floor"),
    line: color("--view-grid"),
    muted: color("--muted"),
    bone: color("--view-bone"),
    joint: color("--view-joint"),
    left: color("--left"),
    right: color("--right"),
    shadow: Number(style.getPropertyValue("--view-shadow")),
  };
}
