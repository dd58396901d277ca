import { firstIndexWhere } from "../../util/binary-search";
import type { Plant } from "../plants/plants";
import type { Clip, Side } from "../types";
import { type Foot, footOf } from "./feet";

/** A footprint on the floor: its centre, the unit direction of the toes, and its length, in metres. */
export interface Footprint {
  x: number;
  z: number;
  dx: number;
  dz: number;
  length: number;
  /** Height of the lowest joint of the foot in the positions of the clip, in metres. */
  y: number;
}

/** Extent of the sole behind the ankle and in front of the tip, relative to ankle to tip. */
const heelOverhang = 0.28;
const toeOverhang = 0.08;

/** The dimensions of a sole, in metres. */
export interface Sole {
  length: number;
  /** Extent in front of the tip. */
  front: number;
  /** Distance from ankle to tip on the floor when the foot is flat. */
  reach: number;
}

/**
 * Returns the sole of a foot, from the lengths of its bones. The length is limited to 0.25 to 0.45
 * of the leg, because some skeletons have no toes.
 */
export function soleOf(clip: Pick<Clip, "positions" | "joints" | "leg">, foot: Foot): Sole {
  const at = (joint: number, axis: number) => clip.positions[3 * joint + axis] ?? 0;
  const between = (a: number, b: number) =>
    Math.hypot(at(a, 0) - at(b, 0), at(a, 1) - at(b, 1), at(a, 2) - at(b, 2));
  // The bone from ankle to toe slopes; its projection on the floor is shorter.
  const reach = Math.max(0.88 * between(foot.ankle, foot.toe) + between(foot.toe, foot.tip), 0.02);
  const natural = reach * (1 + heelOverhang + toeOverhang);
  const leg = clip.leg ?? natural / 0.3;
  const length = Math.min(Math.max(natural, 0.25 * leg), 0.45 * leg);
  return { length, front: toeOverhang * reach + Math.max(length - natural, 0), reach };
}

export interface FootWithSole {
  foot: Foot;
  sole: Sole;
}

/** Returns the joints and the sole of a foot; undefined if the skeleton has no such foot. */
export function footWithSole(clip: Clip, side: Side): FootWithSole | undefined {
  const foot = footOf(clip, side);
  return foot && { foot, sole: soleOf(clip, foot) };
}

/** Returns the footprint of a plant: the sole under the foot in the middle frame of the plant. */
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
  /** Horizontal vector from ankle to tip. */
  const direction = (frame: number) => [
    at(frame, foot.tip, 0) - at(frame, foot.ankle, 0),
    at(frame, foot.tip, 2) - at(frame, foot.ankle, 2),
  ];
  const middle = Math.floor((plant.start + plant.end) / 2);
  let [vx = 0, vz = 0] = direction(middle);
  // A foot that is vertical has no direction; those of the first and last frame are used instead.
  if (Math.hypot(vx, vz) < 0.15 * length) {
    for (const frame of [plant.start, Math.max(plant.end - 1, 0)]) {
      const [x = 0, z = 0] = direction(frame);
      vx += x;
      vz += z;
    }
  }
  const norm = Math.hypot(vx, vz);
  const dx = norm > 1e-6 ? vx / norm : 0;
  const dz = norm > 1e-6 ? vz / norm : 1;
  // Measured from the tip, because the toes are on the floor while the heel is raised.
  const back = length / 2 - front;
  return {
    x: at(middle, foot.tip, 0) - dx * back,
    z: at(middle, foot.tip, 2) - dz * back,
    dx,
    dz,
    length,
    y: Math.min(at(middle, foot.ankle, 1), at(middle, foot.toe, 1), at(middle, foot.tip, 1)),
  };
}

/** A disc on the floor that belongs to an interval of time. */
export interface FloorItem {
  x: number;
  z: number;
  radius: number;
  start: number;
  end: number;
}

/**
 * Returns the interval in which each item is visible: from, until, from, until, …. Of items that
 * overlap in space but not in time, only the nearest in time is visible.
 *
 * @param items Sorted by start.
 */
export function visibilityIntervals(items: readonly FloorItem[]): Float32Array {
  const intervals = new Float32Array(2 * items.length);
  // Items that overlap are in the same cell or in neighbouring ones.
  const width = 2 * Math.max(0, ...items.map(({ radius }) => radius));
  const cells = new Map<number, number[]>();
  items.forEach((later, i) => {
    intervals[2 * i] = -1e9;
    intervals[2 * i + 1] = 1e9;
    const [column, row] = [Math.floor(later.x / width), Math.floor(later.z / width)];
    for (let neighbour = 0; neighbour < 9; neighbour++) {
      const key = cellKey(column + (neighbour % 3) - 1, row + Math.floor(neighbour / 3) - 1);
      for (const j of cells.get(key) ?? []) {
        const earlier = items[j] as FloorItem;
        // Items of the same time are both visible, as are feet that touch each other.
        if (earlier.end > later.start) continue;
        const x = earlier.x - later.x;
        const z = earlier.z - later.z;
        const reach = earlier.radius + later.radius;
        if (x * x + z * z >= reach * reach) continue;
        const change = (earlier.end + later.start) / 2;
        intervals[2 * i] = Math.max(intervals[2 * i] as number, change);
        intervals[2 * j + 1] = Math.min(intervals[2 * j + 1] as number, change);
      }
    }
    const key = cellKey(column, row);
    const cell = cells.get(key);
    if (cell) cell.push(i);
    else cells.set(key, [i]);
  });
  return intervals;
}

/** Returns the key of a cell. On huge floors two cells may share a key, which costs only time. */
const cellKey = (column: number, row: number) => 65_536 * column + row;

/**
 * Number of plants before and after a frame whose footprints are drawn. A window is used until fewer
 * than half as many remain on one side.
 */
const windowRadius = 300;

/** The plants whose footprints are drawn, as a range of indices. */
export interface PlantWindow {
  from: number;
  to: number;
  /** Frames for which this window can be used, half-open. */
  since: number;
  until: number;
}

/** Returns the plants near a frame; those of an hour would be too many to draw. */
export function plantWindowAt(plants: readonly Pick<Plant, "start">[], frame: number): PlantWindow {
  const startOf = (index: number) => (plants[index] as Plant).start;
  const next = firstIndexWhere(plants.length, (index) => startOf(index) > frame);
  const from = Math.max(0, next - windowRadius);
  const to = Math.min(plants.length, next + windowRadius);
  return {
    from,
    to,
    since: from > 0 ? startOf(from + windowRadius / 2) : Number.NEGATIVE_INFINITY,
    until: to < plants.length ? startOf(to - windowRadius / 2) : Number.POSITIVE_INFINITY,
  };
}
