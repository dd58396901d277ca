import type { Scene } from "three";
import { footWithSole } from "../model/motion/footprints";
import { levelAt } from "../model/motion/ground";
import type { GroundPoint } from "../model/motion/trajectory";
import type { Clip, Detection } from "../model/types";
import { Bones } from "./bones";
import { ContactRings } from "./contact-rings";
import type { Palette } from "./palette";
import { Shadow } from "./shadow";

/** One character: its bones, their shadow, and a ring around each planted foot. */
export class Figure {
  private readonly bones: Bones;
  private readonly shadow: Shadow;
  private readonly rings: ContactRings;
  /** For each entry of `footLights` 1 if it is planted, else 0: exact in every frame, without fading. */
  private readonly weights = new Float32Array(5);

  /** `offset` translates the figure on the ground, metres. */
  constructor(
    readonly clip: Clip,
    size: number,
    palette: Palette,
    private readonly offset: GroundPoint = { x: 0, z: 0 },
  ) {
    this.bones = new Bones(clip, size, palette);
    this.shadow = new Shadow(this.bones, size, palette.shadow);
    const feet = [footWithSole(clip, "left"), footWithSole(clip, "right")];
    this.rings = new ContactRings(feet, size, palette);
  }

  addTo(scene: Scene) {
    scene.add(this.shadow.mesh, this.rings.mesh, this.bones.group);
  }

  removeFrom(scene: Scene) {
    scene.remove(this.shadow.mesh, this.rings.mesh, this.bones.group);
  }

  /** Shows a pose; `frame` may be fractional and is limited to the last frame. */
  update(frame: number, groundHeight: number, detection: Detection | null) {
    const { clip, bones, weights, rings } = this;
    const clamped = Math.min(frame, Math.max(clip.frames - 1, 0));
    bones.setPose(clip, clamped, groundHeight, this.offset);
    weights.fill(0);
    if (detection) this.updateWeights(detection, clamped);
    bones.setFootLights(weights);
    this.shadow.update(bones);
    rings.update(
      bones,
      Math.max(weights[1] as number, weights[2] as number),
      Math.max(weights[3] as number, weights[4] as number),
      (height) => (detection ? levelAt(detection, height + groundHeight) : 0),
    );
  }

  private updateWeights({ parts }: Detection, frame: number) {
    const { weights } = this;
    const index = Math.floor(frame + 1e-6);
    const heel = parts.heel ?? parts.contact;
    const toe = parts.toe ?? parts.contact;
    if (heel) {
      weights[1] = heel.left.planted[index] ?? 0;
      weights[3] = heel.right.planted[index] ?? 0;
    }
    if (toe) {
      weights[2] = toe.left.planted[index] ?? 0;
      weights[4] = toe.right.planted[index] ?? 0;
    }
    // A contact that was added by hand may have neither heel nor toe.
    for (const [side, first] of [
      ["left", 1],
      ["right", 3],
    ] as const) {
      if (!parts.contact?.[side].planted[index] || weights[first] || weights[first + 1]) continue;
      weights.fill(1, first, first + 2);
    }
  }

  /** Coordinates of all joints in the pose that is shown, as x, y, z per joint, in metres. */
  get pose(): Float32Array {
    return this.bones.pose;
  }

  dispose() {
    this.bones.dispose();
    this.shadow.dispose();
    this.rings.dispose();
  }
}
