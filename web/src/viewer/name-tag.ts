import { CanvasTexture, type Color, Sprite, SpriteMaterial } from "three";
import type { Palette } from "./palette";

/** Resolution of the text, in pixels per CSS pixel of its font. */
const scale = 2;
const fontSize = 24;
/** Longest name, in characters; the middle of longer ones is left out, since names often differ at the end. */
const maxLength = 28;
/** Height of the text and its distance from the head, as fractions of the size of the character. */
const textHeight = 0.075;
const gap = 0.1;

function shorten(name: string): string {
  const stem = name.replace(/\.bvh$/i, "");
  if (stem.length <= maxLength) return stem;
  const half = Math.floor((maxLength - 1) / 2);
  return `${stem.slice(0, half)}…${stem.slice(-half)}`;
}

function textCanvas(text: string, color: Color): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  const ctx = canvas.getContext("2d");
  if (!ctx) return canvas;
  const font = `600 ${scale * fontSize}px "Inter Variable", system-ui, sans-serif`;
  ctx.font = font;
  canvas.width = Math.ceil(ctx.measureText(text).width) + 2 * scale;
  canvas.height = Math.ceil(1.4 * scale * fontSize);
  ctx.font = font;
  ctx.textBaseline = "middle";
  ctx.fillStyle = `#${color.getHexString()}`;
  ctx.fillText(text, scale, canvas.height / 2);
  return canvas;
}

/** The name of a clip above its character; always turned to the camera. */
export class NameTag {
  readonly sprite: Sprite;

  constructor(
    name: string,
    private readonly size: number,
    palette: Palette,
  ) {
    const canvas = textCanvas(shorten(name), palette.joint);
    const map = new CanvasTexture(canvas);
    this.sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, transparent: true }));
    const height = textHeight * size;
    this.sprite.scale.set((height * canvas.width) / canvas.height, height, 1);
  }

  /** Moves above the highest joint of a pose. */
  moveAbove(pose: Float32Array) {
    let highest = 0;
    for (let i = 1; i < pose.length; i += 3)
      if ((pose[i] as number) > (pose[3 * highest + 1] as number)) highest = (i - 1) / 3;
    const at = (axis: number) => pose[3 * highest + axis] ?? 0;
    this.sprite.position.set(at(0), at(1) + gap * this.size, at(2));
  }

  dispose() {
    this.sprite.material.map?.dispose();
    this.sprite.material.dispose();
  }
}
