import { expect, test } from "vitest";
import type { Clustering } from "../types";
import { type FootFrame, nearestSample, nextSample, rankOfNorm, valueAtRank } from "./evidence";

/** Six frames, one of them not clustered; the norms are given at every other rank. */
const evidence = {
  count: 5,
  ranks: Float32Array.of(0, 2, 4),
  norms: Float32Array.of(0.1, 0.3, 0.9),
  variances: Float32Array.of(0, 0.01, 0.2),
  feet: {
    left: { norms: Float32Array.of(0.1, 0.9, 0.3), values: new Float32Array(3) },
    right: { norms: Float32Array.of(0.2, Number.NaN, 0.6), values: new Float32Array(3) },
  },
} as unknown as Clustering;

test("interpolates the rank of a norm", () => {
  expect(rankOfNorm(evidence, 0.05)).toBe(0);
  expect(rankOfNorm(evidence, 0.2)).toBeCloseTo(1);
  expect(rankOfNorm(evidence, 0.6)).toBeCloseTo(3);
  expect(rankOfNorm(evidence, 7)).toBe(4);
});

test("interpolates norm and variance at a rank", () => {
  expect(valueAtRank(evidence, evidence.norms, 1)).toBeCloseTo(0.2);
  expect(valueAtRank(evidence, evidence.variances, 3)).toBeCloseTo(0.105);
  expect(valueAtRank(evidence, evidence.norms, 9)).toBeCloseTo(0.9);
});

test("finds the nearest sample of either foot and ignores frames that were not clustered", () => {
  expect(nearestSample(evidence, 0.58)).toEqual({ side: "right", frame: 2 });
  expect(nearestSample(evidence, 5)).toEqual({ side: "left", frame: 1 });
});

test("steps through the samples in the order of their norms", () => {
  let current: FootFrame = { side: "left", frame: 0 };
  const visited: string[] = [];
  for (let i = 0; i < 5; i++) {
    current = nextSample(evidence, current, 1);
    visited.push(`${current.side} ${current.frame}`);
  }
  expect(visited).toEqual(["right 0", "left 2", "right 2", "left 1", "left 1"]);
  expect(nextSample(evidence, current, -1)).toEqual({ side: "right", frame: 2 });
});
