import type { Scene } from "three";
import {
  type FloorItem,
  footprintOf,
  footWithSole,
  visibilityIntervals,
} from "../model/footprints";
import type { Plant } from "../model/plants";
import type { Clip } from "../model/types";
import { type FloorNumber, FloorNumbers } from "./floor-numbers";
import type { Palette } from "./palette";
import { Soles } from "./soles";

/** What plants leave on the floor: soles and their numbers. */
export class Footprints {
  private readonly soles: Soles;
  private readonly numbers: FloorNumbers;

  constructor(clip: Clip, plants: readonly Plant[], size: number, palette: Palette) {
    const feet = { left: footWithSole(clip, "left"), right: footWithSole(clip, "right") };
    const known = plants.flatMap((plant) => {
      const found = feet[plant.side];
      if (!found) return [];
      const print = footprintOf(clip, found.foot, found.sole, plant);
      return [{ plant, print, from: plant.start / clip.rate, to: plant.end / clip.rate }];
    });
    const prints = known.map(({ print }) => print);
    const printReigns = visibilityIntervals(
      known.map(({ print: { x, z, length }, from, to }): FloorItem => {
        return { x, z, radius: 0.24 * length, start: from, end: to };
      }),
    );
    this.soles = new Soles(
      known.map(({ plant }) => plant),
      prints,
      printReigns,
      clip.rate,
      palette,
    );
    const height = 0.062 * size;
    const numerals = known.map(({ plant, print, from, to }): FloorNumber => {
      const back = print.length * 0.5 + 0.06 * size;
      const [x, z] = [print.x - print.dx * back, print.z - print.dz * back];
      return { x, z, height, number: plant.number, from, to };
    });
    const numberReigns = visibilityIntervals(
      numerals.map(({ x, z, from, to }): FloorItem => {
        return { x, z, radius: 0.75 * height, start: from, end: to };
      }),
    );
    // A number goes with its sole.
    for (let i = 0; i < numberReigns.length; i += 2) {
      numberReigns[i] = Math.max(numberReigns[i] as number, printReigns[i] as number);
      numberReigns[i + 1] = Math.min(numberReigns[i + 1] as number, printReigns[i + 1] as number);
    }
    this.numbers = new FloorNumbers(numerals, numberReigns, palette.muted, 8 * size);
  }

  enter(scene: Scene) {
    scene.add(this.soles.mesh, this.numbers.mesh);
  }

  leave(scene: Scene) {
    scene.remove(this.soles.mesh, this.numbers.mesh);
  }

  /** `azimuth` and `polar` are the camera's, `x` and `z` where the character is. */
  show(seconds: number, azimuth: number, polar: number, x: number, z: number) {
    this.soles.show(seconds);
    this.numbers.show(seconds, azimuth, polar, x, z);
  }

  dispose() {
    this.soles.dispose();
    this.numbers.dispose();
  }
}
