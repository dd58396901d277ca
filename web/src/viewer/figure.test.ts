import { Color, type InstancedMesh } from "three";
import { expect, it } from "vitest";
import type { Detection } from "../model/types";
import { createWalkingClip, createWalkingTrack } from "../testing/walking-clip";
import { Figure } from "./figure";
import type { Palette } from "./palette";

const clip = createWalkingClip("walk.bvh", 2);
const left = createWalkingTrack(clip, 0, 0.1, 0.6, 0, 17);
// The right foot is never planted.
const tracks = { left, right: { ...left, planted: new Uint8Array(clip.frames) } };
const detection: Detection = {
  options: { method: "robust", r: 0.001, w: 1 },
  parts: { contact: tracks },
  floor: 0,
  ground: { normal: [0, 1, 0], origin: [0, 0, 0], tilt: 0, levels: [0] },
  notices: [],
};
const color = new Color();
const palette: Palette = {
  background: color,
  floor: color,
  grid: color,
  muted: color,
  bone: color,
  joint: color,
  left: color,
  right: color,
  accent: color,
  difference: color,
  shadow: 1,
};

/** Returns the glow of the brightest bone at a moment, in frames. */
function brightest(figure: Figure, moment: number, labels = detection): number {
  figure.update(moment, 0, labels);
  const meshes: InstancedMesh[] = [];
  figure.addTo({
    add: (...objects: { children: unknown[] }[]) => {
      for (const { children } of objects) meshes.push(...(children as InstancedMesh[]));
    },
  } as never);
  return Math.max(
    ...meshes.flatMap(({ geometry }) => [...(geometry.getAttribute("aGlow")?.array ?? [])]),
  );
}

it("lights a foot in exactly the frames in which it is planted", () => {
  const figure = new Figure(clip, 1.75, palette);
  expect(new Set(left.planted)).toEqual(new Set([0, 1]));
  for (let frame = 0; frame < clip.frames; frame++) {
    const isPlanted = left.planted[frame];
    expect(brightest(figure, frame), `frame ${frame}`).toBe(isPlanted);
    // Between two frames, the state is that of the earlier one.
    expect(brightest(figure, frame + 0.9), `frame ${frame + 0.9}`).toBe(isPlanted);
  }
});

it("lights both ends of a foot in a contact without heel and toe", () => {
  const none = { ...left, planted: new Uint8Array(clip.frames) };
  const labels = {
    ...detection,
    parts: {
      ...detection.parts,
      heel: { left: none, right: none },
      toe: { left: none, right: none },
    },
  };
  const figure = new Figure(clip, 1.75, palette);
  for (let frame = 0; frame < clip.frames; frame++)
    expect(brightest(figure, frame, labels), `frame ${frame}`).toBe(left.planted[frame]);
});
