import type { Scene } from "three";
import type { Beside } from "../app/state";
import { extentOf, facingOf, placeOf, sizeOf } from "../lib/travel";
import { Figure } from "./figure";
import type { Lead } from "./lead";
import type { Palette } from "./palette";

/** How far apart characters stand side by side, in heights. */
const apart = 0.75;

/** Another clip beside the one on stage. */
export class Companion {
  private readonly figure: Figure;
  private readonly lowest: number;

  /** The next to the side: by turns left and right of the one on stage, as it faces at first. */
  constructor(
    lead: Lead,
    private readonly beside: Beside,
    place: number,
    palette: Palette,
  ) {
    const { clip } = beside;
    const facing = facingOf(lead.clip, 0);
    const away = apart * lead.size * Math.ceil((place + 1) / 2) * (place % 2 ? -1 : 1);
    const { x, z } = placeOf(clip, clip.roles.hips ?? 0, 0);
    const start = lead.at(0);
    const aside = { x: start.x - x + away * facing.z, z: start.z - z - away * facing.x };
    this.figure = new Figure(clip, sizeOf(clip), palette, aside);
    this.lowest = extentOf(clip, 0).low;
  }

  enter(scene: Scene) {
    this.figure.enter(scene);
  }

  leave(scene: Scene) {
    this.figure.leave(scene);
  }

  show(seconds: number) {
    const { clip, detection } = this.beside;
    this.figure.show(seconds * clip.rate, detection?.floor ?? this.lowest, detection);
  }

  dispose() {
    this.figure.dispose();
  }
}
