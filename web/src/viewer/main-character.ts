import type { Scene } from "three";
import {
  characterSize,
  facingDirection,
  type GroundPoint,
  groundBounds,
  maxHeight,
  smoothedPosition,
  verticalExtent,
} from "../model/trajectory";
import type { Clip, Detection } from "../model/types";
import { Figure } from "./figure";
import { Floor } from "./floor";
import type { Palette } from "./palette";

/** The clip on stage: its figure, the floor under it, and the way it goes. */
export class MainCharacter {
  readonly size: number;
  /** Without labels nobody knows the floor: the lowest joint of the first frame stands on it. */
  readonly lowest: number;
  private readonly hips: number;
  private readonly spot: GroundPoint = { x: 0, z: 0 };
  private readonly next: GroundPoint = { x: 0, z: 0 };
  private readonly floor: Floor;
  private readonly figure: Figure;

  constructor(
    readonly clip: Clip,
    palette: Palette,
  ) {
    this.size = characterSize(clip);
    this.lowest = verticalExtent(clip, 0).low;
    this.hips = clip.roles.hips ?? 0;
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
    return maxHeight(this.clip, this.lowest);
  }

  /** Where it is over the ground at a moment; the next call tells in the same object. */
  at(moment: number): GroundPoint {
    const { clip, hips, spot, next } = this;
    const last = Math.max(clip.frames, 1) - 1;
    const frame = Math.min(Math.floor(moment), last);
    const share = Math.min(moment, last) - frame;
    smoothedPosition(clip, hips, frame, spot);
    smoothedPosition(clip, hips, Math.min(frame + 1, last), next);
    spot.x = mix(spot.x, next.x, share);
    spot.z = mix(spot.z, next.z, share);
    return spot;
  }

  /** The ground that all of its way takes. */
  bounds(): { low: GroundPoint; high: GroundPoint } {
    return groundBounds(this.clip, this.hips);
  }

  /** The angle at which it faces in a frame. */
  facing(frame: number): number {
    const { x, z } = facingDirection(this.clip, Math.min(frame, Math.max(this.clip.frames - 1, 0)));
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
