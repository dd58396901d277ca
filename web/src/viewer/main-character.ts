import type { Scene } from "three";
import {
  characterSize,
  facingDirection,
  type GroundPoint,
  groundBounds,
  maxHeight,
  smoothedPosition,
  verticalExtent,
} from "../model/motion/trajectory";
import type { Clip, Detection } from "../model/types";
import { Figure } from "./figure";
import { Floor } from "./floor";
import type { Palette } from "./palette";

/** The character of the open clip, with the floor under it. */
export class MainCharacter {
  /** Height of the character, in metres. */
  readonly size: number;
  /** Ground height without a detection, in metres: the lowest joint of the first frame. */
  readonly fallbackGroundHeight: number;
  private readonly hips: number;
  private readonly position: GroundPoint = { x: 0, z: 0 };
  private readonly following: GroundPoint = { x: 0, z: 0 };
  private readonly floor: Floor;
  private readonly figure: Figure;

  constructor(
    readonly clip: Clip,
    palette: Palette,
  ) {
    this.size = characterSize(clip);
    this.fallbackGroundHeight = verticalExtent(clip, 0).low;
    this.hips = clip.roles.hips ?? 0;
    this.floor = new Floor(palette, this.size);
    this.figure = new Figure(clip, this.size, palette);
  }

  addTo(scene: Scene) {
    scene.add(this.floor.group);
    this.figure.addTo(scene);
  }

  removeFrom(scene: Scene) {
    scene.remove(this.floor.group);
    this.figure.removeFrom(scene);
  }

  /** Greatest height above the ground, metres. */
  get maxHeight(): number {
    return maxHeight(this.clip, this.fallbackGroundHeight);
  }

  /** Returns the smoothed ground position; the object is reused by the next call. */
  groundPosition(playhead: number): GroundPoint {
    const { clip, hips, position, following } = this;
    const last = Math.max(clip.frames, 1) - 1;
    const frame = Math.min(Math.floor(playhead), last);
    const fraction = Math.min(playhead, last) - frame;
    smoothedPosition(clip, hips, frame, position);
    smoothedPosition(clip, hips, Math.min(frame + 1, last), following);
    position.x = lerp(position.x, following.x, fraction);
    position.z = lerp(position.z, following.z, fraction);
    return position;
  }

  /** Bounding rectangle of the trajectory on the ground. */
  groundBounds(): { low: GroundPoint; high: GroundPoint } {
    return groundBounds(this.clip, this.hips);
  }

  /** Returns the azimuth of the facing direction in a frame, in radians. */
  facingAngle(frame: number): number {
    const { x, z } = facingDirection(this.clip, Math.min(frame, Math.max(this.clip.frames - 1, 0)));
    return Math.atan2(x, z);
  }

  /** Shows the pose at a playhead position, in frames; `isEdgeOn` if the floor is seen as a line. */
  update(playhead: number, groundHeight: number, detection: Detection | null, isEdgeOn: boolean) {
    this.floor.setEdgeOn(isEdgeOn);
    const { x, z } = this.groundPosition(playhead);
    this.floor.moveTo(x, z);
    this.figure.update(playhead, groundHeight, detection);
  }

  /** Coordinates of all joints in the pose that is shown, as x, y, z per joint, in metres. */
  get pose(): Float32Array {
    return this.figure.pose;
  }

  dispose() {
    this.floor.dispose();
    this.figure.dispose();
  }
}

const lerp = (a: number, b: number, t: number) => a + (b - a) * t;
