import type { Clip } from "../worker/types";
import type { Foot } from "./feet";
import type { Plant } from "./plants";

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

/** The mean place of a foot during a plant, from at most 24 of its frames. */
export function footprintOf(
  clip: Pick<Clip, "positions" | "joints" | "frames">,
  foot: Foot,
  plant: Pick<Plant, "start" | "end">,
): Footprint {
  const { positions } = clip;
  const stride = clip.joints.length * 3;
  const last = Math.max(clip.frames - 1, 0);
  const length = Math.max(1, plant.end - plant.start);
  const samples = Math.min(length, 24);
  let ax = 0;
  let az = 0;
  let vx = 0;
  let vz = 0;
  let reach = 0;
  for (let k = 0; k < samples; k++) {
    const frame = Math.min(last, plant.start + Math.floor(((k + 0.5) * length) / samples));
    const ankle = frame * stride + foot.ankle * 3;
    const toe = frame * stride + foot.toe * 3;
    const tip = frame * stride + foot.tip * 3;
    const at = (i: number) => positions[i] ?? 0;
    ax += at(ankle);
    az += at(ankle + 2);
    vx += at(tip) - at(ankle) + (at(toe) - at(ankle));
    vz += at(tip + 2) - at(ankle + 2) + (at(toe + 2) - at(ankle + 2));
    // Along the foot, not its shadow: a foot on its toes is no shorter.
    reach +=
      Math.hypot(at(toe) - at(ankle), at(toe + 2) - at(ankle + 2)) +
      Math.hypot(at(tip) - at(toe), at(tip + 1) - at(toe + 1), at(tip + 2) - at(toe + 2));
  }
  ax /= samples;
  az /= samples;
  reach /= samples;
  const norm = Math.hypot(vx, vz);
  const dx = norm > 1e-6 ? vx / norm : 0;
  const dz = norm > 1e-6 ? vz / norm : 1;
  const middle = (reach * (1 + before - behind)) / 2;
  return {
    x: ax + dx * middle,
    z: az + dz * middle,
    dx,
    dz,
    length: Math.max(reach, 0.02) * (1 + behind + before),
  };
}
