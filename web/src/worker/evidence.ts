/** Evidence in as few numbers as a picture of it takes. */

import type { RawDetection } from "../wasm/plantigrade";
import type { Evidence, Field, Part, Place, Side, Why } from "./types";

/** More points than this no panel is wide enough for. */
const mostPoints = 512;

/** Steps of the field's grid to a side. */
const size = 48;

export function whyOf(raw: RawDetection, part: Part, reach: Place): Why {
  const why: Why = { part, limits: raw.limits() };
  if (raw.hasEvidence(part)) why.evidence = evidenceOf(raw, part, reach);
  return why;
}

function evidenceOf(raw: RawDetection, part: Part, reach: Place): Evidence {
  const facts = raw.evidence(part);
  const sorted = raw.sortedNorms(part);
  const running = raw.runningVariance(part);
  const ranks = evenly(sorted.length, mostPoints, facts.knee);
  const foot = (side: Side) => ({ norms: raw.norms(part, side), roots: raw.roots(part, side) });
  const evidence: Evidence = {
    ...facts,
    count: sorted.length,
    ranks,
    norms: ranks.map((rank) => sorted[rank] as number),
    variances: ranks.map((rank) => running[rank] as number),
    feet: { left: foot("left"), right: foot("right") },
  };
  if (facts.hasField) evidence.field = fieldOf(raw, part, reach);
  return evidence;
}

/** At most so many of the numbers below `count`, the first, the last and one more among them. */
export function evenly(count: number, most: number, also: number): Float32Array {
  const step = Math.max(1, (count - 1) / (most - 2));
  const found = new Set<number>(count ? [also, count - 1] : []);
  for (let at = 0; at < count; at += step) found.add(Math.round(at));
  return Float32Array.from(found).sort();
}

function fieldOf(raw: RawDetection, part: Part, reach: Place): Field {
  // Feet that stand are crowded near the origin: there the steps are small.
  const steps = (top: number) =>
    Float64Array.from({ length: size }, (_, i) => top * (i / (size - 1)) ** 2);
  return { reach, size, roots: raw.field(part, steps(reach.height), steps(reach.speed)) };
}
