import type { Scene } from "three";
import { extentOf, facingOf, reachOf, sizeOf, travelOf } from "../lib/travel";
import type { Clip, Detection } from "../worker/types";
import { Figure, type Spot } from "./figure";
import { Floor } from "./floor";
import type { Palette } from "./palette";

/** The clip on stage: its figure, the floor under it, and the way it goes. */
export class Lead {
  readonly size: number;
  /** Without labels nobody knows the floor: the lowest joint of the first frame stands on it. */
  readonly lowest: number;
  private readonly path: Float32Array;
  private readonly spot: Spot = { x: 0, z: 0 };
  private readonly floor: Floor;
  private readonly figure: Figure;

  constructor(
    readonly clip: Clip,
    palette: Palette,
  ) {
    this.size = sizeOf(clip);
    this.lowest = extentOf(clip, 0).low;
    this.path = travelOf(clip, clip.roles.hips ?? 0);
    this.floor = new Floor(palette, this.size);
    this.figure = new Figure(clip, this.size, palette);
  }

  enter(scene: Scene) {
    scene.add(this.floor.mesh);
    this.figure.enter(scene);
  }

  leave(scene: Scene) {
    scene.remove(this.floor.mesh);
    this.figure.leave(scene);
  }

  /** How high it comes over its floor. */
  get reach(): number {
    return reachOf(this.clip, this.lowest);
  }

  /** Where it is over the ground at a moment; the next call tells in the same object. */
  at(moment: number): Spot {
    const { path, spot } = this;
    const last = path.length / 2 - 1;
    const frame = Math.min(Math.floor(moment), last);
    const next = Math.min(frame + 1, last);
    const share = Math.min(moment, last) - frame;
    spot.x = mix(path[2 * frame] as number, path[2 * next] as number, share);
    spot.z = mix(path[2 * frame + 1] as number, path[2 * next + 1] as number, share);
    return spot;
  }

  /** The ground that all of its way takes. */
  bounds(): { low: Spot; high: Spot } {
    const low = { x: Number.POSITIVE_INFINITY, z: Number.POSITIVE_INFINITY };
    const high = { x: Number.NEGATIVE_INFINITY, z: Number.NEGATIVE_INFINITY };
    for (let i = 0; i < this.path.length; i += 2) {
      const [x = 0, z = 0] = [this.path[i], this.path[i + 1]];
      low.x = Math.min(low.x, x);
      low.z = Math.min(low.z, z);
      high.x = Math.max(high.x, x);
      high.z = Math.max(high.z, z);
    }
    return { low, high };
  }

  /** The angle at which it faces in a frame. */
  facing(frame: number): number {
    const { x, z } = facingOf(this.clip, Math.min(frame, Math.max(this.clip.frames - 1, 0)));
    return Math.atan2(x, z);
  }

  /** Puts it where a moment has it; `height` is that of its floor. */
  show(moment: number, height: number, detection: Detection | null) {
    const { x, z } = this.at(moment);
    this.floor.moveTo(x, z);
    this.figure.show(moment, height, detection);
  }

  dispose() {
    this.floor.dispose();
    this.figure.dispose();
  }
}

const mix = (a: number, b: number, share: number) => a + (b - a) * share;
