import type { Clip } from "../worker/types";

/**
 * Where the character is over the ground, per frame (x, z, x, z …), averaged over
 * ± 0.4 s: a camera on it glides, and is at the same place whichever way time came.
 */
export function travelOf(
  clip: Pick<Clip, "positions" | "joints" | "frames" | "rate">,
  joint: number,
) {
  const frames = Math.max(clip.frames, 1);
  const stride = clip.joints.length * 3;
  const reach = Math.round(0.4 * clip.rate);
  const path = new Float32Array(2 * frames);
  const along = new Float32Array(frames);
  for (let axis = 0; axis < 2; axis++) {
    for (let frame = 0; frame < frames; frame++) {
      along[frame] = clip.positions[frame * stride + joint * 3 + 2 * axis] ?? 0;
    }
    let sum = 0;
    let from = 0;
    let to = 0;
    for (let frame = 0; frame < frames; frame++) {
      // Symmetric at the ends too, so that the first frame is its own mean.
      const half = Math.min(reach, frame, frames - 1 - frame);
      for (; to <= frame + half; to++) sum += along[to] as number;
      for (; from < frame - half; from++) sum -= along[from] as number;
      for (; to > frame + half + 1; to--) sum -= along[to - 1] as number;
      path[2 * frame + axis] = sum / (2 * half + 1);
    }
  }
  return path;
}

/** Lowest and highest point of one frame, metres. */
export function extentOf(clip: Pick<Clip, "positions" | "joints">, frame: number) {
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
export function reachOf(
  clip: Pick<Clip, "positions" | "joints" | "frames">,
  floor: number,
): number {
  const stride = Math.max(1, Math.floor(clip.frames / 240));
  let high = Number.NEGATIVE_INFINITY;
  for (let frame = 0; frame < Math.max(clip.frames, 1); frame += stride) {
    high = Math.max(high, extentOf(clip, frame).high);
  }
  return high - floor;
}

/** Unit direction the character faces on the floor, from the line between its hips; +z where that is unknown. */
export function facingOf(clip: Pick<Clip, "positions" | "joints" | "roles">, frame: number) {
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
export function sizeOf(clip: Pick<Clip, "positions" | "joints" | "leg">): number {
  const { low, high } = extentOf(clip, 0);
  return Math.max(high - low, 1.2 * (clip.leg ?? 0), 1e-3);
}

/** The floor's grid in metres: 1 for people, a power of ten for the very small and the very large. */
export function gridStep(size: number): number {
  return 10 ** Math.round(Math.log10(size / 1.75));
}
