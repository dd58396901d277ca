import type { Clustering, Edit, Evidence, Side, Tracks } from "./types";

/** What a foot's label in a frame is read from. */
export interface ExplanationInput {
  evidence: Evidence;
  tracks: Tracks;
  edits: readonly Edit[];
}

/** What a foot is labelled in a frame, and why. */
export interface Explanation {
  label: string;
  reason: string;
}

export function explain(
  { evidence, tracks, edits }: ExplanationInput,
  side: Side,
  frame: number,
): Explanation {
  const { part, clustering } = evidence;
  const planted = tracks[side].planted[frame] === 1;
  const label = `${side === "left" ? "Left" : "Right"} ${planted ? "planted" : "in the air"}`;
  const isHere = (edit: Edit) =>
    edit.side === side && edit.part === part && edit.start <= frame && frame < edit.end;
  if (edits.some(isHere)) return { label, reason: "as you said" };
  const reason = clustering
    ? byClustering(clustering, side, frame, planted)
    : byThresholds(evidence, tracks, side, frame);
  return { label, reason };
}

function byClustering(clustering: Clustering, side: Side, frame: number, planted: boolean): string {
  const value = clustering.feet[side].values[frame] ?? Number.NaN;
  if (Number.isNaN(value)) return "left out, as the next frame";
  const { threshold } = clustering;
  if (!Number.isFinite(threshold)) return "all frames are alike";
  const unit = unitOf(clustering);
  const above = value > threshold;
  const compared = `${formatValue(value / unit)}, ${comparison(above)} ${formatValue(threshold / unit)}`;
  return planted === (above === clustering.plantedIsHigh)
    ? `${valueName(clustering)} ${compared}`
    : `${compared}, cleaned up`;
}

function byThresholds({ thresholds }: Evidence, tracks: Tracks, side: Side, frame: number): string {
  const height = 100 * (tracks[side].height[frame] ?? 0);
  const speed = tracks[side].speed[frame] ?? 0;
  const words: string[] = [];
  if (thresholds.height !== undefined) {
    const most = 100 * thresholds.height;
    words.push(`${formatValue(height)} cm, ${comparison(height >= most)} ${formatValue(most)}`);
  }
  if (thresholds.speed !== undefined) {
    words.push(
      `${formatValue(speed)} m/s, ${comparison(speed >= thresholds.speed)} ${formatValue(thresholds.speed)}`,
    );
  }
  return words.join(";\n") || `${formatValue(height)} cm, ${formatValue(speed)} m/s`;
}

const comparison = (above: boolean) => (above ? "above" : "below");

/** Roots of degrees count in those of a foot that is well planted; other values as they are. */
function unitOf({ hasField, plantedMedian }: Clustering): number {
  return hasField && plantedMedian > 0 ? plantedMedian : 1;
}

/** What u is. */
const valueName = ({ hasField }: Clustering) => (hasField ? "√degree" : "u");

/** As many digits as tell something. */
export function formatValue(value: number): string {
  return value.toFixed(Math.abs(value) < 10 ? 2 : 1).replace("-", "−");
}
