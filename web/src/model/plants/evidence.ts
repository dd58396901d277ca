import { niceCeiling } from "../../util/axis-steps";
import { firstIndexWhere } from "../../util/binary-search";
import { quantile } from "../../util/min-max-pyramid";
import type { Clustering, Side, Tracks } from "../types";

/** One foot in one frame; its sample, if it was clustered. */
export interface FootFrame {
  side: Side;
  frame: number;
}

export const sides = ["left", "right"] as const;

/**
 * Returns upper limits of heights (m) and speeds (m/s) for a plot: the 99.8th percentiles, rounded
 * up, so that single outliers do not compress the axes.
 */
export function heightSpeedRange({ left, right }: Tracks) {
  const top = (kind: "height" | "speed") =>
    niceCeiling(Math.max(...[left, right].map((track) => quantile(track[kind], 0.998))));
  return { height: top("height"), speed: top("speed") };
}

/** Returns the fractional rank of a norm in the sorted norms, by linear interpolation. */
export function rankOfNorm({ ranks, norms }: Clustering, norm: number): number {
  const after = firstIndexWhere(norms.length, (i) => (norms[i] as number) >= norm);
  return interpolate(norms, ranks, after, norm);
}

/** Returns the norm or the variance at a fractional rank, by linear interpolation. */
export function valueAtRank({ ranks }: Clustering, values: Float32Array, rank: number): number {
  const after = firstIndexWhere(ranks.length, (i) => (ranks[i] as number) >= rank);
  return interpolate(ranks, values, after, rank);
}

/** Interpolates y at x; `after` is the first index whose x is not below it. Clamped at the ends. */
function interpolate(xs: Float32Array, ys: Float32Array, after: number, x: number): number {
  if (after <= 0) return ys[0] ?? 0;
  if (after >= xs.length) return ys[ys.length - 1] ?? 0;
  const [x0, x1] = [xs[after - 1] as number, xs[after] as number];
  const [y0, y1] = [ys[after - 1] as number, ys[after] as number];
  return x1 > x0 ? y0 + ((x - x0) / (x1 - x0)) * (y1 - y0) : y1;
}

/** Returns the sample whose norm is closest to a given one. */
export function nearestSample({ feet }: Clustering, norm: number): FootFrame | undefined {
  let nearest: FootFrame | undefined;
  let minDistance = Number.POSITIVE_INFINITY;
  for (const side of sides) {
    const { norms } = feet[side];
    for (let frame = 0; frame < norms.length; frame++) {
      const distance = Math.abs((norms[frame] as number) - norm);
      if (distance < minDistance) {
        minDistance = distance;
        nearest = { side, frame };
      }
    }
  }
  return nearest;
}

/** Returns the sample `step` ranks further in the order of the norms; the same one at the ends. */
export function nextSample(evidence: Clustering, from: FootFrame, step: number): FootFrame {
  let rank = rankOfNorm(evidence, evidence.feet[from.side].norms[from.frame] as number);
  // Equal or interpolated norms may lead back to the same sample; then a further step is taken.
  for (let attempt = 0; attempt < 32; attempt++) {
    rank += step;
    const sample = nearestSample(evidence, valueAtRank(evidence, evidence.norms, rank));
    if (sample && (sample.frame !== from.frame || sample.side !== from.side)) return sample;
    if (rank < 0 || rank >= evidence.count) break;
  }
  return from;
}
