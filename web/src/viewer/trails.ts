import {
  BufferGeometry,
  type Color,
  DynamicDrawUsage,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
} from "three";
import { footOf } from "../model/feet";
import type { Clip } from "../model/types";
import type { Palette } from "./palette";

/** Seconds before and after the moment that a trail shows. */
const span = 1;

/** A trail has at most so many points: at higher rates it leaves frames out. */
const most = 240;

/** The way of both toes and of the root around the moment, fading with distance in time. */
export class Trails {
  readonly group = new Group();
  private readonly joints: readonly number[];
  private readonly lines: readonly Line<BufferGeometry, LineBasicMaterial>[];
  private readonly step: number;

  constructor(
    private readonly clip: Clip,
    palette: Palette,
  ) {
    this.step = Math.max(1, Math.ceil((2 * span * clip.rate) / most));
    const ways: readonly (readonly [number | undefined, Color])[] = [
      [footOf(clip, "left")?.toe, palette.left],
      [footOf(clip, "right")?.toe, palette.right],
      [clip.roles.hips ?? 0, palette.muted],
    ];
    const known = ways.filter((way): way is readonly [number, Color] => way[0] !== undefined);
    this.joints = known.map(([joint]) => joint);
    this.lines = known.map(([, color]) => trail(color));
    this.group.add(...this.lines);
  }

  show(moment: number, floor: number) {
    const { clip, step } = this;
    const reach = span * clip.rate;
    const last = Math.max(clip.frames - 1, 0);
    // On whole steps, so that the same points stay on the trail while time goes on.
    const first = Math.ceil(Math.max(0, moment - reach) / step) * step;
    const end = Math.min(last, moment + reach);
    const stride = 3 * clip.joints.length;
    this.lines.forEach((line, i) => {
      const joint = 3 * (this.joints[i] as number);
      const places = line.geometry.getAttribute("position") as Float32BufferAttribute;
      const colors = line.geometry.getAttribute("color") as Float32BufferAttribute;
      let count = 0;
      for (let frame = first; frame <= end && count < most; frame += step, count++) {
        const at = frame * stride + joint;
        const [x, y, z] = [clip.positions[at], clip.positions[at + 1], clip.positions[at + 2]];
        places.setXYZ(count, x as number, (y as number) - floor, z as number);
        colors.setW(count, 0.9 * (1 - Math.abs(frame - moment) / reach));
      }
      places.needsUpdate = true;
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

function trail(color: Color) {
  const geometry = new BufferGeometry();
  const colors = new Float32Array(4 * most);
  for (let i = 0; i < most; i++) color.toArray(colors, 4 * i);
  const attributes = {
    position: new Float32BufferAttribute(new Float32Array(3 * most), 3),
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
