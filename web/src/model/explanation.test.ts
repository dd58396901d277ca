import { expect, test } from "vitest";
import { summarizeCurve } from "../util/min-max-pyramid";
import { explain } from "./explanation";
import type { Clustering, Evidence, Side, Track, Tracks } from "./types";

const track = (planted: number[]): Track => ({
  planted: Uint8Array.from(planted),
  confidence: new Float32Array(planted.length).fill(1),
  intervals: new Uint32Array(),
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

const say = (about: Evidence, side: Side, frame: number) => {
  const { label, reason } = explain({ evidence: about, tracks, edits: [] }, side, frame);
  return `${label}: ${reason}`;
};

test("a frame is planted because its degree is above the threshold", () => {
  expect(say(evidence, "left", 0)).toBe("Left planted: √degree 0.91, above 0.60");
  expect(say(evidence, "right", 0)).toBe("Right in the air: √degree 0.40, below 0.60");
});

test("what is labelled otherwise than its degree says was cleaned up", () => {
  expect(say(evidence, "left", 1)).toBe("Left planted: 0.50, below 0.60, cleaned up");
  expect(say(evidence, "right", 1)).toBe("Right in the air: 0.70, above 0.60, cleaned up");
});

test("frames that were not clustered, and clips that are all alike, say so", () => {
  expect(say(evidence, "left", 3)).toBe("Left planted: left out, as the next frame");
  const alike = { ...clustering, threshold: Number.NEGATIVE_INFINITY };
  expect(say({ ...evidence, clustering: alike }, "right", 3)).toBe(
    "Right planted: all frames are alike",
  );
});

test("values that are no degrees are as they are, and may be planted below", () => {
  const other = { ...clustering, hasField: false, plantedIsHigh: false };
  expect(say({ ...evidence, clustering: other }, "right", 3)).toBe(
    "Right planted: 11.0, above 6.00, cleaned up",
  );
  expect(say({ ...evidence, clustering: other }, "right", 1)).toBe(
    "Right in the air: u 7.00, above 6.00",
  );
});

test("a person's word counts more", () => {
  const edit = { side: "left", part: "contact", start: 2, end: 4, planted: false } as const;
  const reason = (frame: number) =>
    explain({ evidence, tracks, edits: [edit] }, "left", frame).reason;
  expect([1, 2, 3].map(reason).map((text) => text === "as you said")).toEqual([false, true, true]);
});

test("thresholds are named, and methods without any show what there is", () => {
  const plain: Evidence = { part: "toe", thresholds: { height: 0.05, speed: 0.5 } };
  expect(say(plain, "left", 0)).toBe("Left planted: 2.10 cm, below 5.00;\n0.10 m/s, below 0.50");
  expect(say({ ...plain, thresholds: {} }, "left", 2)).toBe("Left in the air: 20.0 cm, 12.0 m/s");
});
