import type { Scene } from "three";
import {
  type FloorItem,
  footprintOf,
  footWithSole,
  visibilityIntervals,
} from "../model/motion/footprints";
import { levelAt } from "../model/motion/ground";
import type { Plant } from "../model/plants/plants";
import type { Clip, Detection } from "../model/types";
import { type FloorNumber, FloorNumbers } from "./floor-numbers";
import type { Palette } from "./palette";
import { Soles } from "./soles";

/** Footprints of plants on the floor, with the plant numbers. */
export class Footprints {
  private readonly soles: Soles;
  private readonly numbers: FloorNumbers;

  constructor(
    clip: Clip,
    detection: Detection,
    plants: readonly Plant[],
    size: number,
    palette: Palette,
  ) {
    const feet = { left: footWithSole(clip, "left"), right: footWithSole(clip, "right") };
    const items = plants.flatMap((plant) => {
      const entry = feet[plant.side];
      if (!entry) return [];
      const footprint = footprintOf(clip, entry.foot, entry.sole, plant);
      return [{ plant, footprint, from: plant.start / clip.rate, to: plant.end / clip.rate }];
    });
    const footprints = items.map(({ footprint }) => {
      return { ...footprint, level: levelAt(detection, footprint.y) };
    });
    const soleVisibility = visibilityIntervals(
      items.map(({ footprint: { x, z, length }, from, to }): FloorItem => {
        return { x, z, radius: 0.24 * length, start: from, end: to };
      }),
    );
    this.soles = new Soles(
      items.map(({ plant }) => plant),
      footprints,
      soleVisibility,
      clip.rate,
      palette,
    );
    const height = 0.062 * size;
    const numbers = items.map(({ plant, footprint, from, to }, i): FloorNumber => {
      const distance = footprint.length * 0.5 + 0.06 * size;
      const [x, z] = [footprint.x - footprint.dx * distance, footprint.z - footprint.dz * distance];
      const level = footprints[i]?.level ?? 0;
      return { x, z, level, height, number: plant.number, from, to };
    });
    const numberVisibility = visibilityIntervals(
      numbers.map(({ x, z, from, to }): FloorItem => {
        return { x, z, radius: 0.75 * height, start: from, end: to };
      }),
    );
    // A number is visible only while its footprint is.
    for (let i = 0; i < numberVisibility.length; i += 2) {
      numberVisibility[i] = Math.max(numberVisibility[i] as number, soleVisibility[i] as number);
      numberVisibility[i + 1] = Math.min(
        numberVisibility[i + 1] as number,
        soleVisibility[i + 1] as number,
      );
    }
    this.numbers = new FloorNumbers(numbers, numberVisibility, palette.muted, 8 * size);
  }

  addTo(scene: Scene) {
    scene.add(this.soles.mesh, this.numbers.mesh);
  }

  removeFrom(scene: Scene) {
    scene.remove(this.soles.mesh, this.numbers.mesh);
  }

  /** `azimuth` and `polar` are angles of the camera; `x` and `z` the position of the character. */
  update(seconds: number, azimuth: number, polar: number, x: number, z: number) {
    this.soles.update(seconds);
    this.numbers.update(seconds, azimuth, polar, x, z);
  }

  dispose() {
    this.soles.dispose();
    this.numbers.dispose();
  }
}
