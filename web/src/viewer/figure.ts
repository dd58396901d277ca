import type { Scene } from "three";
import { footWithSole } from "../model/footprints";
import { contactWeight } from "../model/plants";
import type { GroundPoint } from "../model/trajectory";
import type { Clip, Detection } from "../model/types";
import { Bones } from "./bones";
import { ContactRings } from "./contact-rings";
import type { Palette } from "./palette";
import { Shadow } from "./shadow";

/** Seconds before and after an edge within which a foot's light swells or fades. */
const swell = 0.045;

/** One character on stage: its bones, their shadow, and a ring around each planted foot. */
export class Figure {
  private readonly bones: Bones;
  private readonly shadow: Shadow;
  private readonly rings: ContactRings;
  private readonly shares = new Float32Array(5);

  /** `aside` is where it stands, measured from where its clip has it. */
  constructor(
    readonly clip: Clip,
    size: number,
    palette: Palette,
    private readonly aside: GroundPoint = { x: 0, z: 0 },
  ) {
    this.bones = new Bones(clip, size, palette);
    this.shadow = new Shadow(this.bones, size, palette.shadow);
    const feet = [footWithSole(clip, "left"), footWithSole(clip, "right")];
    this.rings = new ContactRings(feet, size, palette);
  }

  enter(scene: Scene) {
    scene.add(this.shadow.mesh, this.rings.mesh, this.bones.group);
  }

  leave(scene: Scene) {
    scene.remove(this.shadow.mesh, this.rings.mesh, this.bones.group);
  }

  /** Puts it where a moment between two frames has it; after its last frame it stands still. */
  show(moment: number, floor: number, detection: Detection | null) {
    const { clip, bones, shares, rings } = this;
    const here = Math.min(moment, Math.max(clip.frames - 1, 0));
    bones.show(clip, here, floor, this.aside);
    shares.fill(0);
    if (detection) this.measureLight(detection, here);
    bones.light(shares);
    this.shadow.show(bones);
    rings.show(
      bones,
      Math.max(shares[1] as number, shares[2] as number),
      Math.max(shares[3] as number, shares[4] as number),
    );
  }

  private measureLight({ parts }: Detection, moment: number) {
    const { shares } = this;
    const reach = swell * this.clip.rate;
    const heel = parts.heel ?? parts.contact;
    const toe = parts.toe ?? parts.contact;
    if (heel) {
      shares[1] = contactWeight(heel.left.planted, moment, reach);
      shares[3] = contactWeight(heel.right.planted, moment, reach);
    }
    if (toe) {
      shares[2] = contactWeight(toe.left.planted, moment, reach);
      shares[4] = contactWeight(toe.right.planted, moment, reach);
    }
  }

  dispose() {
    this.bones.dispose();
    this.shadow.dispose();
    this.rings.dispose();
  }
}
