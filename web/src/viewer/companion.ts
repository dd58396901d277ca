import type { Scene } from "three";
import {
  characterSize,
  facingDirection,
  smoothedPosition,
  verticalExtent,
} from "../model/motion/trajectory";
import type { Companion } from "../model/sources/source";
import { Figure } from "./figure";
import type { MainCharacter } from "./main-character";
import type { Palette } from "./palette";

/** Distance between neighbouring characters, as a multiple of the character height. */
const spacing = 0.75;

/** Returns the distance of a comparison clip from the main character of a size, in metres. */
export const companionDistance = (size: number, index: number) =>
  spacing * size * Math.ceil((index + 1) / 2);

/** The figure of a comparison clip. */
export class CompanionFigure {
  private readonly figure: Figure;
  private readonly fallbackGroundHeight: number;

  /** Placed alternately to the left and right of the main character, relative to its initial facing. */
  constructor(
    mainCharacter: MainCharacter,
    private readonly companion: Companion,
    index: number,
    palette: Palette,
  ) {
    const { clip } = companion;
    const facing = facingDirection(mainCharacter.clip, 0);
    const sideOffset = companionDistance(mainCharacter.size, index) * (index % 2 ? -1 : 1);
    const { x, z } = smoothedPosition(clip, clip.roles.hips ?? 0, 0);
    const start = mainCharacter.groundPosition(0);
    const offset = {
      x: start.x - x + sideOffset * facing.z,
      z: start.z - z - sideOffset * facing.x,
    };
    this.figure = new Figure(clip, characterSize(clip), palette, offset);
    this.fallbackGroundHeight = verticalExtent(clip, 0).low;
  }

  addTo(scene: Scene) {
    this.figure.addTo(scene);
  }

  removeFrom(scene: Scene) {
    this.figure.removeFrom(scene);
  }

  /** Shows the pose at a time of the main clip, in seconds. */
  update(seconds: number) {
    const { clip, detection } = this.companion;
    this.figure.update(
      seconds * clip.rate,
      detection?.floor ?? this.fallbackGroundHeight,
      detection,
    );
  }

  /** Coordinates of all joints in the pose that is shown, as x, y, z per joint, in metres. */
  get pose(): Float32Array {
    return this.figure.pose;
  }

  dispose() {
    this.figure.dispose();
  }
}
