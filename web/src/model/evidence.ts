import { niceCeiling } from "../util/axis-steps";
import { firstIndexWhere } from "../util/binary-search";
import { quantile } from "../util/min-max-pyramid";
import type { Clustering, Side, Tracks } from "./types";

/** One foot in one frame. */
export interface FootFrame {
  side: Side;
  frame: number;
}

export const sides = ["left", "right"] as const;

/** How far the heights and speeds of feet reach, but for a few that would squeeze the rest. */
export function heightSpeedRange({ left, right }: Tracks) {
  const top = (kind: "height" | "speed") =>
    niceCeiling(Math.max(...[left, right].map((track) => quantile(track[kind], 0.998))));
  return { height: top("height"), speed: top("speed") };
}

/** Where a norm lies among all norms in ascending order, between two places as between their norms. */
export function rankOfNorm({ ranks, norms }: Clustering, norm: number): number {
  const after = firstIndexWhere(norms.length, (i) => (norms[i] as number) >= norm);
  return interpolate(norms, ranks, after, norm);
}

/** The norm or the variance at a place among the norms, between two known ones as between those. */
export function valueAtRank({ ranks }: Clustering, values: Float32Array, rank: number): number {
  const after = firstIndexWhere(ranks.length, (i) => (ranks[i] as number) >= rank);
  return interpolate(ranks, values, after, rank);
}

function interpolate(from: Float32Array, to: Float32Array, after: number, at: number): number {
  if (after <= 0) return to[0] ?? 0;
  if (after >= from.length) return to[to.length - 1] ?? 0;
  const [a, b] = [from[after - 1] as number, from[after] as number];
  const [low, high] = [to[after - 1] as number, to[after] as number];
  return b > a ? low + ((at - a) / (b - a)) * (high - low) : high;
}

/** The sample whose norm is closest to one. */
export function nearestSample({ feet }: Clustering, norm: number): FootFrame | undefined {
  let best: FootFrame | undefined;
  let least = Number.POSITIVE_INFINITY;
  for (const side of sides) {
    const { norms } = feet[side];
    for (let frame = 0; frame < norms.length; frame++) {
      const off = Math.abs((norms[frame] as number) - norm);
      if (off < least) {
        least = off;
        best = { side, frame };
      }
    }
  }
  return best;
}

/** The next sample in the order of the norms, some places on; the same at the end. */
export function nextSample(evidence: Clustering, from: FootFrame, places: number): FootFrame {
  let rank = rankOfNorm(evidence, evidence.feet[from.side].norms[from.frame] as number);
  // Norms that are equal, or lie between two known ones, may lead back to where one was.
  for (let tries = 0; tries < 32; tries++) {
    rank += places;
    const found = nearestSample(evidence, valueAtRank(evidence, evidence.norms, rank));
    if (found && (found.frame !== from.frame || found.side !== from.side)) return found;
    if (rank < 0 || rank >= evidence.count) break;
  }
  return from;
}
