import type { Scene } from "three";
import type { Companion } from "../model/source";
import {
  characterSize,
  facingDirection,
  smoothedPosition,
  verticalExtent,
} from "../model/trajectory";
import { Figure } from "./figure";
import type { MainCharacter } from "./main-character";
import type { Palette } from "./palette";

/** How far apart characters stand side by side, in heights. */
const apart = 0.75;

/** Another clip beside the one on stage. */
export class CompanionFigure {
  private readonly figure: Figure;
  private readonly lowest: number;

  /** The next to the side: by turns left and right of the one on stage, as it faces at first. */
  constructor(
    lead: MainCharacter,
    private readonly companion: Companion,
    place: number,
    palette: Palette,
  ) {
    const { clip } = companion;
    const facing = facingDirection(lead.clip, 0);
    const away = apart * lead.size * Math.ceil((place + 1) / 2) * (place % 2 ? -1 : 1);
    const { x, z } = smoothedPosition(clip, clip.roles.hips ?? 0, 0);
    const start = lead.at(0);
    const aside = { x: start.x - x + away * facing.z, z: start.z - z - away * facing.x };
    this.figure = new Figure(clip, characterSize(clip), palette, aside);
    this.lowest = verticalExtent(clip, 0).low;
  }

  enter(scene: Scene) {
    this.figure.enter(scene);
  }

  leave(scene: Scene) {
    this.figure.leave(scene);
  }

  show(seconds: number) {
    const { clip, detection } = this.companion;
    this.figure.show(seconds * clip.rate, detection?.floor ?? this.lowest, detection);
  }

  dispose() {
    this.figure.dispose();
  }
}
