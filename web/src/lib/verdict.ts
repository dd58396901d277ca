import type { Edit, Evidence, Side, Tracks, Why } from "../worker/types";

/** What a foot's label in a frame is read from. */
export interface Case {
  why: Why;
  tracks: Tracks;
  edits: readonly Edit[];
}

/** What a foot is labelled in a frame, and why. */
export interface Verdict {
  label: string;
  reason: string;
}

export function verdict({ why, tracks, edits }: Case, side: Side, frame: number): Verdict {
  const { part, evidence } = why;
  const planted = tracks[side].planted[frame] === 1;
  const label = `${side === "left" ? "Left" : "Right"} ${planted ? "planted" : "in the air"}`;
  const isHere = (edit: Edit) =>
    edit.side === side && edit.part === part && edit.start <= frame && frame < edit.end;
  if (edits.some(isHere)) return { label, reason: "as you said" };
  const reason = evidence
    ? byEvidence(evidence, side, frame, planted)
    : byLimits(why, tracks, side, frame);
  return { label, reason };
}

function byEvidence(evidence: Evidence, side: Side, frame: number, planted: boolean): string {
  const root = evidence.feet[side].roots[frame] ?? Number.NaN;
  if (Number.isNaN(root)) return "left out, as the next frame";
  const { threshold } = evidence;
  if (!Number.isFinite(threshold)) return "all frames are alike";
  const unit = unitOf(evidence);
  const above = root > threshold;
  const compared = `${number(root / unit)}, ${than(above)} ${number(threshold / unit)}`;
  return planted === (above === evidence.plantedIsHigh)
    ? `${nameOf(evidence)} ${compared}`
    : `${compared}, cleaned up`;
}

function byLimits({ limits }: Why, tracks: Tracks, side: Side, frame: number): string {
  const height = 100 * (tracks[side].height[frame] ?? 0);
  const speed = tracks[side].speed[frame] ?? 0;
  const words: string[] = [];
  if (limits.height !== undefined) {
    const most = 100 * limits.height;
    words.push(`${number(height)} cm, ${than(height >= most)} ${number(most)}`);
  }
  if (limits.speed !== undefined) {
    words.push(`${number(speed)} m/s, ${than(speed >= limits.speed)} ${number(limits.speed)}`);
  }
  return words.join(";\n") || `${number(height)} cm, ${number(speed)} m/s`;
}

const than = (above: boolean) => (above ? "above" : "below");

/** Roots of degrees count in those of a foot that is well planted; other values as they are. */
function unitOf({ hasField, plantedMiddle }: Evidence): number {
  return hasField && plantedMiddle > 0 ? plantedMiddle : 1;
}

/** What u is. */
const nameOf = ({ hasField }: Evidence) => (hasField ? "√degree" : "u");

/** As many digits as tell something. */
export function number(value: number): string {
  return value.toFixed(Math.abs(value) < 10 ? 2 : 1).replace("-", "−");
}
