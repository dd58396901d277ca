import { expect, test } from "vitest";
import { type FootFrame, nearestSample, nextSample, rankOfNorm, valueAtRank } from "./evidence";
import type { Clustering } from "./types";

/** Six samples, one of them left out; every other norm is known. */
const evidence = {
  count: 5,
  ranks: Float32Array.of(0, 2, 4),
  norms: Float32Array.of(0.1, 0.3, 0.9),
  variances: Float32Array.of(0, 0.01, 0.2),
  feet: {
    left: { norms: Float32Array.of(0.1, 0.9, 0.3), roots: new Float32Array(3) },
    right: { norms: Float32Array.of(0.2, Number.NaN, 0.6), roots: new Float32Array(3) },
  },
} as unknown as Clustering;

test("norms have ranks, those between known ones too", () => {
  expect(rankOfNorm(evidence, 0.05)).toBe(0);
  expect(rankOfNorm(evidence, 0.2)).toBeCloseTo(1);
  expect(rankOfNorm(evidence, 0.6)).toBeCloseTo(3);
  expect(rankOfNorm(evidence, 7)).toBe(4);
});

test("a rank has a norm and a variance", () => {
  expect(valueAtRank(evidence, evidence.norms, 1)).toBeCloseTo(0.2);
  expect(valueAtRank(evidence, evidence.variances, 3)).toBeCloseTo(0.105);
  expect(valueAtRank(evidence, evidence.norms, 9)).toBeCloseTo(0.9);
});

test("the sample of a norm is found in either foot, and none that was left out", () => {
  expect(nearestSample(evidence, 0.58)).toEqual({ side: "right", frame: 2 });
  expect(nearestSample(evidence, 5)).toEqual({ side: "left", frame: 1 });
});

test("one after the other, samples are met in the order of their norms", () => {
  let at: FootFrame = { side: "left", frame: 0 };
  const met: string[] = [];
  for (let i = 0; i < 5; i++) {
    at = nextSample(evidence, at, 1);
    met.push(`${at.side} ${at.frame}`);
  }
  expect(met).toEqual(["right 0", "left 2", "right 2", "left 1", "left 1"]);
  expect(nextSample(evidence, at, -1)).toEqual({ side: "right", frame: 2 });
});
