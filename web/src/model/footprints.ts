import { firstIndexWhere } from "../util/binary-search";
import { type Foot, footOf } from "./feet";
import type { Plant } from "./plants";
import type { Clip, Side } from "./types";

/** A sole on the floor: its middle, the unit direction of the toes, its length (metres). */
export interface Footprint {
  x: number;
  z: number;
  dx: number;
  dz: number;
  length: number;
}

/** How far the heel stands out behind the ankle and the toes before the tip, as shares of ankle to tip. */
const behind = 0.28;
const before = 0.08;

/** The sole of a foot: how long it is, and how far it goes on before the tip. */
export interface Sole {
  length: number;
  front: number;
  /** From ankle to tip, where the foot lies flat. */
  reach: number;
}

/** A sole as long as the foot's own bones say; a foot cut short by its skeleton gets its toes back. */
export function soleOf(clip: Pick<Clip, "positions" | "joints" | "leg">, foot: Foot): Sole {
  const at = (joint: number, axis: number) => clip.positions[3 * joint + axis] ?? 0;
  const between = (a: number, b: number) =>
    Math.hypot(at(a, 0) - at(b, 0), at(a, 1) - at(b, 1), at(a, 2) - at(b, 2));
  // From the ankle to the toe a bone slants: on the floor it is shorter.
  const reach = Math.max(0.88 * between(foot.ankle, foot.toe) + between(foot.toe, foot.tip), 0.02);
  const own = reach * (1 + behind + before);
  const leg = clip.leg ?? own / 0.3;
  const length = Math.min(Math.max(own, 0.25 * leg), 0.45 * leg);
  return { length, front: before * reach + Math.max(length - own, 0), reach };
}

export interface FootWithSole {
  foot: Foot;
  sole: Sole;
}

export function footWithSole(clip: Clip, side: Side): FootWithSole | undefined {
  const foot = footOf(clip, side);
  return foot && { foot, sole: soleOf(clip, foot) };
}

/** Where a sole lies during a plant: under the foot as it stands in the middle of it. */
export function footprintOf(
  clip: Pick<Clip, "positions" | "joints" | "frames">,
  foot: Foot,
  { length, front }: Pick<Sole, "length" | "front">,
  plant: Pick<Plant, "start" | "end">,
): Footprint {
  const { positions } = clip;
  const stride = clip.joints.length * 3;
  const last = Math.max(clip.frames - 1, 0);
  const at = (frame: number, joint: number, axis: number) =>
    positions[Math.min(frame, last) * stride + joint * 3 + axis] ?? 0;
  /** From ankle to tip on the floor. */
  const along = (frame: number) => [
    at(frame, foot.tip, 0) - at(frame, foot.ankle, 0),
    at(frame, foot.tip, 2) - at(frame, foot.ankle, 2),
  ];
  const middle = Math.floor((plant.start + plant.end) / 2);
  let [vx = 0, vz = 0] = along(middle);
  // A foot that stands upright on its toes points where it did when it came and will when it goes.
  if (Math.hypot(vx, vz) < 0.15 * length) {
    for (const frame of [plant.start, Math.max(plant.end - 1, 0)]) {
      const [x = 0, z = 0] = along(frame);
      vx += x;
      vz += z;
    }
  }
  const norm = Math.hypot(vx, vz);
  const dx = norm > 1e-6 ? vx / norm : 0;
  const dz = norm > 1e-6 ? vz / norm : 1;
  // Measured from the tip: when the heel is up, the toes are what stands on the floor.
  const back = length / 2 - front;
  return {
    x: at(middle, foot.tip, 0) - dx * back,
    z: at(middle, foot.tip, 2) - dz * back,
    dx,
    dz,
    length,
  };
}

/** Something that lies on the floor during a span of time. */
export interface FloorItem {
  x: number;
  z: number;
  radius: number;
  start: number;
  end: number;
}

/**
 * Where things lie on each other, the one nearest in time is seen: from when until when
 * that is each one, [from, until, from, until …] in their unit of time. `list` is in order of start.
 */
export function visibilityIntervals(list: readonly FloorItem[]): Float32Array {
  const found = new Float32Array(2 * list.length);
  // What lies on something lies in the same cell as that or in one beside it.
  const width = 2 * Math.max(0, ...list.map(({ radius }) => radius));
  const cells = new Map<number, number[]>();
  list.forEach((late, i) => {
    found[2 * i] = -1e9;
    found[2 * i + 1] = 1e9;
    const [column, row] = [Math.floor(late.x / width), Math.floor(late.z / width)];
    for (let beside = 0; beside < 9; beside++) {
      const cell = cellOf(column + (beside % 3) - 1, row + Math.floor(beside / 3) - 1);
      for (const j of cells.get(cell) ?? []) {
        const early = list[j] as FloorItem;
        // Both at once are seen both: feet side by side.
        if (early.end > late.start) continue;
        const x = early.x - late.x;
        const z = early.z - late.z;
        const apart = early.radius + late.radius;
        if (x * x + z * z >= apart * apart) continue;
        const handover = (early.end + late.start) / 2;
        found[2 * i] = Math.max(found[2 * i] as number, handover);
        found[2 * j + 1] = Math.min(found[2 * j + 1] as number, handover);
      }
    }
    const own = cellOf(column, row);
    const others = cells.get(own);
    if (others) others.push(i);
    else cells.set(own, [i]);
  });
  return found;
}

/** Where the floor is so wide that two cells share a number, those in both are only looked at in vain. */
const cellOf = (column: number, row: number) => 65_536 * column + row;

/** Before and after a moment so many plants leave prints, and never fewer than half of that. */
const windowRadius = 300;

/** The plants whose prints lie on the floor, from one place in their list to another. */
export interface PlantWindow {
  from: number;
  to: number;
  /** The frames for which these are enough. */
  since: number;
  until: number;
}

/** The plants near a moment: of an hour's walk nobody sees more, and all would be a crowd. */
export function plantWindowAt(plants: readonly Pick<Plant, "start">[], frame: number): PlantWindow {
  const at = (place: number) => (plants[place] as Plant).start;
  const now = firstIndexWhere(plants.length, (place) => at(place) > frame);
  const from = Math.max(0, now - windowRadius);
  const to = Math.min(plants.length, now + windowRadius);
  return {
    from,
    to,
    since: from > 0 ? at(from + windowRadius / 2) : Number.NEGATIVE_INFINITY,
    until: to < plants.length ? at(to - windowRadius / 2) : Number.POSITIVE_INFINITY,
  };
}
