import type { Clip } from "../types";

/** A position on the ground plane, in metres. */
export interface GroundPoint {
  x: number;
  z: number;
}

/**
 * Returns the ground position of a joint, averaged over ± 0.4 s, so that a camera that follows it
 * moves smoothly. Depends on the frame only, not on the direction of playback.
 *
 * @param target Object to which the result is written.
 */
export function smoothedPosition(
  clip: Pick<Clip, "positions" | "joints" | "frames" | "rate">,
  joint: number,
  frame: number,
  target: GroundPoint = { x: 0, z: 0 },
): GroundPoint {
  const stride = clip.joints.length * 3;
  const last = Math.max(clip.frames, 1) - 1;
  // The window shrinks symmetrically at the ends of the clip, which avoids a lag there.
  const half = Math.min(Math.round(0.4 * clip.rate), frame, last - frame);
  target.x = 0;
  target.z = 0;
  for (let i = frame - half; i <= frame + half; i++) {
    const index = i * stride + joint * 3;
    target.x += clip.positions[index] ?? 0;
    target.z += clip.positions[index + 2] ?? 0;
  }
  target.x /= 2 * half + 1;
  target.z /= 2 * half + 1;
  return target;
}

/** Returns the bounds of the path of a joint on the ground, from ten frames per second. */
export function groundBounds(
  clip: Pick<Clip, "positions" | "joints" | "frames" | "rate">,
  joint: number,
): { low: GroundPoint; high: GroundPoint } {
  const low = { x: Number.POSITIVE_INFINITY, z: Number.POSITIVE_INFINITY };
  const high = { x: Number.NEGATIVE_INFINITY, z: Number.NEGATIVE_INFINITY };
  const step = Math.max(1, Math.floor(clip.rate / 10));
  for (let frame = 0; frame < Math.max(clip.frames, 1); frame += step) {
    const index = (frame * clip.joints.length + joint) * 3;
    const [x = 0, z = 0] = [clip.positions[index], clip.positions[index + 2]];
    low.x = Math.min(low.x, x);
    low.z = Math.min(low.z, z);
    high.x = Math.max(high.x, x);
    high.z = Math.max(high.z, z);
  }
  return { low, high };
}

/** Returns the height of the lowest and the highest joint in a frame, in metres. */
export function verticalExtent(clip: Pick<Clip, "positions" | "joints">, frame: number) {
  const stride = clip.joints.length * 3;
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (let joint = 0; joint < clip.joints.length; joint++) {
    const y = clip.positions[frame * stride + joint * 3 + 1] ?? 0;
    if (y < low) low = y;
    if (y > high) high = y;
  }
  return { low, high };
}

/** Returns the largest height of any joint above the floor, in metres, from about 240 frames. */
export function maxHeight(
  clip: Pick<Clip, "positions" | "joints" | "frames">,
  floor: number,
): number {
  const step = Math.max(1, Math.floor(clip.frames / 240));
  let high = Number.NEGATIVE_INFINITY;
  for (let frame = 0; frame < Math.max(clip.frames, 1); frame += step) {
    high = Math.max(high, verticalExtent(clip, frame).high);
  }
  return high - floor;
}

/** Returns the unit vector on the ground in which the hips face; +z if it is unknown. */
export function facingDirection(clip: Pick<Clip, "positions" | "joints" | "roles">, frame: number) {
  const left = clip.roles.left_thigh;
  const right = clip.roles.right_thigh;
  if (left === undefined || right === undefined) return { x: 0, z: 1 };
  const base = frame * clip.joints.length * 3;
  const coordinate = (joint: number, axis: number) => clip.positions[base + joint * 3 + axis] ?? 0;
  const dx = coordinate(left, 0) - coordinate(right, 0);
  const dz = coordinate(left, 2) - coordinate(right, 2);
  const norm = Math.hypot(dx, dz);
  // Left × up = forward, in right-handed coordinates with Y up.
  return norm > 1e-6 ? { x: -dz / norm, z: dx / norm } : { x: 0, z: 1 };
}

/** Returns the size of the character in metres: its height in the first frame, or 1.2 leg lengths. */
export function characterSize(clip: Pick<Clip, "positions" | "joints" | "leg">): number {
  const { low, high } = verticalExtent(clip, 0);
  return Math.max(high - low, 1.2 * (clip.leg ?? 0), 1e-3);
}

/** Returns the grid spacing for a character, in metres: 1 for people, otherwise a power of ten. */
export function gridStep(size: number): number {
  return 10 ** Math.round(Math.log10(size / 1.75));
}
