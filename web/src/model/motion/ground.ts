import type { Detection } from "../types";

/** Plane of the ground in the viewer, whose floor is at height 0: height = x · slopeX + z · slopeZ + offset. */
export interface GroundPlane {
  slopeX: number;
  slopeZ: number;
  /** In metres. */
  offset: number;
}

const flat: GroundPlane = { slopeX: 0, slopeZ: 0, offset: 0 };

/** Returns the plane of the ground; ground that is not tilted is the floor. */
export function groundPlane(detection: Pick<Detection, "ground" | "floor"> | null): GroundPlane {
  if (!detection?.ground.tilt) return flat;
  const { normal, origin } = detection.ground;
  const [slopeX, slopeZ] = [-normal[0] / normal[1], -normal[2] / normal[1]];
  const offset = origin[1] - detection.floor - slopeX * origin[0] - slopeZ * origin[2];
  return { slopeX, slopeZ, offset };
}

/**
 * Returns the height of the level above the plane that is nearest to a foot, in metres; 0 if there is
 * one level only.
 *
 * @param y Height of the lowest joint of the foot in the positions of the clip.
 */
export function levelAt({ ground, floor }: Pick<Detection, "ground" | "floor">, y: number): number {
  if (ground.tilt || ground.levels.length < 2) return 0;
  const heights = ground.levels.map((level) => level + ground.origin[1]);
  const distance = (height: number) => Math.abs(height - y);
  return heights.reduce((a, b) => (distance(b) < distance(a) ? b : a)) - floor;
}

/** Returns the ground in words: `tilted by 8.0°, belt 1.20 m/s`; undefined if it is level and at rest. */
export function groundText({ tilt, levels, belt }: Detection["ground"]): string | undefined {
  const facts = [
    tilt && `tilted by ${tilt.toFixed(1)}°`,
    levels.length > 1 && `${levels.length} levels`,
    belt && `belt ${Math.hypot(...belt).toFixed(2)} m/s`,
  ];
  return facts.filter(Boolean).join(", ") || undefined;
}
