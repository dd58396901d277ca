import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  LineBasicMaterial,
  LineSegments,
} from "three";
import { footOf } from "../model/motion/feet";
import type { Clip } from "../model/types";
import type { Palette } from "./palette";

/** Factor by which the lines exceed the distances that they show. */
export const offsetScale = 4;

/** Lines from the joints of the feet towards their places in another pose, enlarged. */
export class FootOffsets {
  readonly lines: LineSegments;
  private readonly joints: readonly number[];
  private readonly points: BufferAttribute;

  constructor(clip: Clip, palette: Palette) {
    const feet = [footOf(clip, "left"), footOf(clip, "right")];
    this.joints = [
      ...new Set(feet.flatMap((foot) => (foot ? [foot.ankle, foot.toe, foot.tip] : []))),
    ];
    this.points = new BufferAttribute(new Float32Array(6 * this.joints.length), 3);
    this.points.setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.points);
    const material = new LineBasicMaterial({ color: palette.difference, depthTest: false });
    this.lines = new LineSegments(geometry, material);
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 1;
  }

  /** Shows the differences of two poses: x, y, z per joint, in metres. */
  update(pose: Float32Array, other: Float32Array) {
    const { array } = this.points;
    for (const [i, joint] of this.joints.entries()) {
      for (let axis = 0; axis < 3; axis++) {
        const from = pose[3 * joint + axis] as number;
        const to = other[3 * joint + axis] as number;
        array[6 * i + axis] = from;
        array[6 * i + 3 + axis] = from + offsetScale * (to - from);
      }
    }
    this.points.needsUpdate = true;
  }

  dispose() {
    this.lines.geometry.dispose();
    (this.lines.material as LineBasicMaterial).dispose();
  }
}
