import type { Clustering, Edit, Evidence, Side, Tracks } from "../types";

/** All data that determine the label of a foot in a frame. */
export interface ExplanationInput {
  evidence: Evidence;
  tracks: Tracks;
  edits: readonly Edit[];
}

/** The label of a foot in a frame and the reason for it, as displayed. */
export interface Explanation {
  label: string;
  reason: string;
}

/** Explains the label of a foot in a frame. */
export function explain(
  { evidence, tracks, edits }: ExplanationInput,
  side: Side,
  frame: number,
): Explanation {
  const { part, clustering } = evidence;
  const planted = tracks[side].planted[frame] === 1;
  const label = `${side === "left" ? "Left" : "Right"} ${planted ? "planted" : "in the air"}`;
  const appliesHere = (edit: Edit) =>
    edit.side === side && edit.part === part && edit.start <= frame && frame < edit.end;
  if (edits.some(appliesHere)) return { label, reason: "edited" };
  const reason = clustering
    ? clusteringReason(clustering, side, frame, planted)
    : thresholdReason(evidence, tracks, side, frame);
  return { label, reason };
}

function clusteringReason(
  clustering: Clustering,
  side: Side,
  frame: number,
  planted: boolean,
): string {
  const value = clustering.feet[side].values[frame] ?? Number.NaN;
  if (Number.isNaN(value)) return "excluded, label of nearest frame";
  const { threshold } = clustering;
  if (!Number.isFinite(threshold)) return "all frames are similar";
  const unit = unitOf(clustering);
  const above = value > threshold;
  const compared = `${formatValue(value / unit)}, ${comparison(above)} ${formatValue(threshold / unit)}`;
  return planted === (above === clustering.plantedIsHigh)
    ? `${valueName(clustering)} ${compared}`
    : `${compared}, post-processed`;
}

function thresholdReason(
  { thresholds }: Evidence,
  tracks: Tracks,
  side: Side,
  frame: number,
): string {
  const height = 100 * (tracks[side].height[frame] ?? 0);
  const speed = tracks[side].speed[frame] ?? 0;
  const conditions: string[] = [];
  if (thresholds.height !== undefined) {
    const limit = 100 * thresholds.height;
    conditions.push(
      `${formatValue(height)} cm, ${comparison(height >= limit)} ${formatValue(limit)}`,
    );
  }
  if (thresholds.speed !== undefined) {
    conditions.push(
      `${formatValue(speed)} m/s, ${comparison(speed >= thresholds.speed)} ${formatValue(thresholds.speed)}`,
    );
  }
  return conditions.join(";\n") || `${formatValue(height)} cm, ${formatValue(speed)} m/s`;
}

const comparison = (above: boolean) => (above ? "above" : "below");

/** Unit of displayed decision values: the median sqrt-degree of planted frames, otherwise 1. */
function unitOf({ hasField, plantedMedian }: Clustering): number {
  return hasField && plantedMedian > 0 ? plantedMedian : 1;
}

/** Name of the decision value. */
const valueName = ({ hasField }: Clustering) => (hasField ? "√degree" : "u");

/** Formats a value with about three significant digits and a typographic minus. */
export function formatValue(value: number): string {
  return value.toFixed(Math.abs(value) < 10 ? 2 : 1).replace("-", "−");
}
