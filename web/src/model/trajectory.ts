import type { Clip } from "./types";

/** A place over the ground, metres. */
export interface GroundPoint {
  x: number;
  z: number;
}

/**
 * Where the character is over the ground in a frame, averaged over ± 0.4 s: a camera on it
 * glides, and is at the same place whichever way time came. Told in `spot`.
 */
export function smoothedPosition(
  clip: Pick<Clip, "positions" | "joints" | "frames" | "rate">,
  joint: number,
  frame: number,
  spot: GroundPoint = { x: 0, z: 0 },
): GroundPoint {
  const stride = clip.joints.length * 3;
  const last = Math.max(clip.frames, 1) - 1;
  // Symmetric at the ends too, so that the first frame is its own mean.
  const half = Math.min(Math.round(0.4 * clip.rate), frame, last - frame);
  spot.x = 0;
  spot.z = 0;
  for (let near = frame - half; near <= frame + half; near++) {
    const place = near * stride + joint * 3;
    spot.x += clip.positions[place] ?? 0;
    spot.z += clip.positions[place + 2] ?? 0;
  }
  spot.x /= 2 * half + 1;
  spot.z /= 2 * half + 1;
  return spot;
}

/** The ground that all of its way takes, from ten frames of a second. */
export function groundBounds(
  clip: Pick<Clip, "positions" | "joints" | "frames" | "rate">,
  joint: number,
): { low: GroundPoint; high: GroundPoint } {
  const low = { x: Number.POSITIVE_INFINITY, z: Number.POSITIVE_INFINITY };
  const high = { x: Number.NEGATIVE_INFINITY, z: Number.NEGATIVE_INFINITY };
  const step = Math.max(1, Math.floor(clip.rate / 10));
  for (let frame = 0; frame < Math.max(clip.frames, 1); frame += step) {
    const place = (frame * clip.joints.length + joint) * 3;
    const [x = 0, z = 0] = [clip.positions[place], clip.positions[place + 2]];
    low.x = Math.min(low.x, x);
    low.z = Math.min(low.z, z);
    high.x = Math.max(high.x, x);
    high.z = Math.max(high.z, z);
  }
  return { low, high };
}

/** Lowest and highest point of one frame, metres. */
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

/** Greatest height over `floor` that any joint reaches, from at most 240 frames, metres. */
export function maxHeight(
  clip: Pick<Clip, "positions" | "joints" | "frames">,
  floor: number,
): number {
  const stride = Math.max(1, Math.floor(clip.frames / 240));
  let high = Number.NEGATIVE_INFINITY;
  for (let frame = 0; frame < Math.max(clip.frames, 1); frame += stride) {
    high = Math.max(high, verticalExtent(clip, frame).high);
  }
  return high - floor;
}

/** Unit direction the character faces on the floor, from the line between its hips; +z where that is unknown. */
export function facingDirection(clip: Pick<Clip, "positions" | "joints" | "roles">, frame: number) {
  const left = clip.roles.left_thigh;
  const right = clip.roles.right_thigh;
  if (left === undefined || right === undefined) return { x: 0, z: 1 };
  const base = frame * clip.joints.length * 3;
  const at = (joint: number, axis: number) => clip.positions[base + joint * 3 + axis] ?? 0;
  const lx = at(left, 0) - at(right, 0);
  const lz = at(left, 2) - at(right, 2);
  const norm = Math.hypot(lx, lz);
  // Left × up = forward, in a right-handed world with y up.
  return norm > 1e-6 ? { x: -lz / norm, z: lx / norm } : { x: 0, z: 1 };
}

/** Height of the character in metres, from its first pose; a crawling one counts by its legs. */
export function characterSize(clip: Pick<Clip, "positions" | "joints" | "leg">): number {
  const { low, high } = verticalExtent(clip, 0);
  return Math.max(high - low, 1.2 * (clip.leg ?? 0), 1e-3);
}

/** The floor's grid in metres: 1 for people, a power of ten for the very small and the very large. */
export function gridStep(size: number): number {
  return 10 ** Math.round(Math.log10(size / 1.75));
}
