import {
  BufferGeometry,
  type Color,
  DynamicDrawUsage,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
} from "three";
import { footOf } from "../model/motion/feet";
import type { Clip } from "../model/types";
import type { Palette } from "./palette";

/** Time shown before and after the playhead, in seconds. */
const trailSeconds = 1;

/** Greatest number of points of a trail; frames are skipped at higher rates. */
const maxPoints = 240;

/** Trajectories of both toes and of the root around the playhead, fading with time. */
export class Trails {
  readonly group = new Group();
  private readonly joints: readonly number[];
  private readonly lines: readonly Line<BufferGeometry, LineBasicMaterial>[];
  private readonly step: number;

  constructor(
    private readonly clip: Clip,
    palette: Palette,
  ) {
    this.step = Math.max(1, Math.ceil((2 * trailSeconds * clip.rate) / maxPoints));
    const candidates: readonly (readonly [number | undefined, Color])[] = [
      [footOf(clip, "left")?.toe, palette.left],
      [footOf(clip, "right")?.toe, palette.right],
      [clip.roles.hips ?? 0, palette.muted],
    ];
    const available = candidates.filter(
      (entry): entry is readonly [number, Color] => entry[0] !== undefined,
    );
    this.joints = available.map(([joint]) => joint);
    this.lines = available.map(([, color]) => createTrail(color));
    this.group.add(...this.lines);
  }

  update(playhead: number, groundHeight: number) {
    const { clip, step } = this;
    const radiusFrames = trailSeconds * clip.rate;
    const last = Math.max(clip.frames - 1, 0);
    // Multiples of the step, so that the points do not change during playback.
    const first = Math.ceil(Math.max(0, playhead - radiusFrames) / step) * step;
    const end = Math.min(last, playhead + radiusFrames);
    const stride = 3 * clip.joints.length;
    this.lines.forEach((line, i) => {
      const joint = 3 * (this.joints[i] as number);
      const positions = line.geometry.getAttribute("position") as Float32BufferAttribute;
      const colors = line.geometry.getAttribute("color") as Float32BufferAttribute;
      let count = 0;
      for (let frame = first; frame <= end && count < maxPoints; frame += step, count++) {
        const offset = frame * stride + joint;
        const [x, y, z] = [
          clip.positions[offset],
          clip.positions[offset + 1],
          clip.positions[offset + 2],
        ];
        positions.setXYZ(count, x as number, (y as number) - groundHeight, z as number);
        colors.setW(count, 0.9 * (1 - Math.abs(frame - playhead) / radiusFrames));
      }
      positions.needsUpdate = true;
      colors.needsUpdate = true;
      line.geometry.setDrawRange(0, count);
    });
  }

  dispose() {
    for (const { geometry, material } of this.lines) {
      geometry.dispose();
      material.dispose();
    }
  }
}

function createTrail(color: Color) {
  const geometry = new BufferGeometry();
  const colors = new Float32Array(4 * maxPoints);
  for (let i = 0; i < maxPoints; i++) color.toArray(colors, 4 * i);
  const attributes = {
    position: new Float32BufferAttribute(new Float32Array(3 * maxPoints), 3),
    color: new Float32BufferAttribute(colors, 4),
  };
  for (const [name, attribute] of Object.entries(attributes)) {
    geometry.setAttribute(name, attribute.setUsage(DynamicDrawUsage));
  }
  const material = new LineBasicMaterial({
    vertexColors: true,
    transparent: true,
    depthWrite: false,
  });
  const line = new Line(geometry, material);
  line.frustumCulled = false;
  return line;
}
