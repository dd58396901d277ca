import { expect, test } from "vitest";
import { summarizeCurve } from "../../util/min-max-pyramid";
import type { Clustering, Evidence, Side, Track, Tracks } from "../types";
import { explain } from "./explanation";

const track = (planted: number[]): Track => ({
  planted: Uint8Array.from(planted),
  confidence: new Float32Array(planted.length).fill(1),
  intervals: new Uint32Array(),
  instants: new Float64Array(),
  edited: new Uint8Array(),
  uncertain: new Uint32Array(),
  height: Float32Array.from(planted, (on) => (on ? 0.021 : 0.2)),
  speed: Float32Array.from(planted, (on) => (on ? 0.1 : 12)),
  summaries: {
    height: summarizeCurve(new Float32Array()),
    speed: summarizeCurve(new Float32Array()),
  },
});
const tracks: Tracks = { left: track([1, 1, 0, 1]), right: track([0, 0, 0, 1]) };
const foot = (values: number[]) => ({
  norms: new Float32Array(4),
  values: Float32Array.from(values),
});
const clustering: Clustering = {
  knee: 1,
  sigmaIsLimited: false,
  sigma: 0.2,
  r: 0.001,
  tolerance: 0.001,
  threshold: 6,
  plantedIsHigh: true,
  plantedMedian: 10,
  hasField: true,
  count: 8,
  ranks: new Float32Array(),
  norms: new Float32Array(),
  variances: new Float32Array(),
  feet: { left: foot([9.1, 5, 2, Number.NaN]), right: foot([4, 7, 1, 11]) },
};
const evidence: Evidence = { part: "contact", thresholds: {}, clustering };

const explainText = (of: Evidence, side: Side, frame: number) => {
  const { label, reason } = explain({ evidence: of, tracks, edits: [] }, side, frame);
  return `${label}: ${reason}`;
};

test("compares the decision value with the threshold", () => {
  expect(explainText(evidence, "left", 0)).toBe("Left planted: √degree 0.91, above 0.60");
  expect(explainText(evidence, "right", 0)).toBe("Right in the air: √degree 0.40, below 0.60");
});

test("reports labels that post-processing has changed", () => {
  expect(explainText(evidence, "left", 1)).toBe("Left planted: 0.50, below 0.60, post-processed");
  expect(explainText(evidence, "right", 1)).toBe(
    "Right in the air: 0.70, above 0.60, post-processed",
  );
});

test("reports frames that were not clustered, and clips without a threshold", () => {
  expect(explainText(evidence, "left", 3)).toBe("Left planted: excluded, label of nearest frame");
  const similar = { ...clustering, threshold: Number.NEGATIVE_INFINITY };
  expect(explainText({ ...evidence, clustering: similar }, "right", 3)).toBe(
    "Right planted: all frames are similar",
  );
});

test("shows other decision values in their own unit, also if planted ones are below the threshold", () => {
  const other = { ...clustering, hasField: false, plantedIsHigh: false };
  expect(explainText({ ...evidence, clustering: other }, "right", 3)).toBe(
    "Right planted: 11.0, above 6.00, post-processed",
  );
  expect(explainText({ ...evidence, clustering: other }, "right", 1)).toBe(
    "Right in the air: u 7.00, above 6.00",
  );
});

test("an edit takes precedence", () => {
  const edit = { side: "left", part: "contact", start: 2, end: 4, planted: false } as const;
  const reason = (frame: number) =>
    explain({ evidence, tracks, edits: [edit] }, "left", frame).reason;
  expect([1, 2, 3].map(reason).map((text) => text === "edited")).toEqual([false, true, true]);
});

test("compares height and speed with thresholds, or shows them without", () => {
  const thresholded: Evidence = { part: "toe", thresholds: { height: 0.05, speed: 0.5 } };
  expect(explainText(thresholded, "left", 0)).toBe(
    "Left planted: 2.10 cm, below 5.00;\n0.10 m/s, below 0.50",
  );
  expect(explainText({ ...thresholded, thresholds: {} }, "left", 2)).toBe(
    "Left in the air: 20.0 cm, 12.0 m/s",
  );
});
