/** Reduces the evidence of a detection to the points that a plot can show. */

import type { Clustering, DecisionField, Evidence, HeightSpeed, Part, Side } from "../model/types";
import type { WasmDetection } from "../wasm/plantigrade";

/** Maximum number of points of a curve, at least the width of a panel in pixels. */
const maxPoints = 512;

/** Points per axis of the decision field. */
const gridSize = 48;

/** `max` is the largest height and speed of interest. */
export function evidenceToPlain(detection: WasmDetection, part: Part, max: HeightSpeed): Evidence {
  const evidence: Evidence = { part, thresholds: detection.thresholds() };
  if (detection.hasEvidence(part)) evidence.clustering = clusteringToPlain(detection, part, max);
  return evidence;
}

function clusteringToPlain(detection: WasmDetection, part: Part, max: HeightSpeed): Clustering {
  const info = detection.evidence(part);
  const sorted = detection.sortedNorms(part);
  const running = detection.runningVariance(part);
  const ranks = sampleIndices(sorted.length, maxPoints, info.knee);
  const foot = (side: Side) => ({
    norms: detection.norms(part, side),
    values: detection.decisionValues(part, side),
  });
  const clustering: Clustering = {
    ...info,
    count: sorted.length,
    ranks,
    norms: ranks.map((rank) => sorted[rank] as number),
    variances: ranks.map((rank) => running[rank] as number),
    feet: { left: foot("left"), right: foot("right") },
  };
  if (info.hasField) clustering.field = decisionFieldToPlain(detection, part, max);
  return clustering;
}

/** Returns at most `max` evenly spaced indices below `count`, including both ends and `extra`. */
export function sampleIndices(count: number, max: number, extra: number): Float32Array {
  const step = Math.max(1, (count - 1) / (max - 2));
  const indices = new Set<number>(count ? [extra, count - 1] : []);
  for (let at = 0; at < count; at += step) indices.add(Math.round(at));
  return Float32Array.from(indices).sort();
}

function decisionFieldToPlain(
  detection: WasmDetection,
  part: Part,
  max: HeightSpeed,
): DecisionField {
  // Planted feet concentrate near the origin, where the steps are small.
  const steps = (top: number) =>
    Float64Array.from({ length: gridSize }, (_, i) => top * (i / (gridSize - 1)) ** 2);
  const values = detection.decisionField(part, steps(max.height), steps(max.speed));
  return { max, size: gridSize, values };
}
