import { expect, it } from "vitest";
import { firstIntervalAfter } from "../model/plants/intervals";
import { forEachVisible } from "./visible-intervals";

const visible = (intervals: number[], view: { start: number; end: number }, width: number) => {
  const list: [number, number, boolean][] = [];
  forEachVisible(Uint32Array.from(intervals), view, width, (...bar) => list.push(bar));
  return list;
};

it("draws well separated intervals individually", () => {
  expect(visible([10, 14, 15, 20], { start: 0, end: 64 }, 64)).toEqual([
    [10, 14, false],
    [15, 20, false],
  ]);
});

it("skips intervals outside the view", () => {
  expect(visible([0, 5, 8, 12, 30, 40], { start: 6, end: 26 }, 20)).toEqual([[2, 6, false]]);
});

it("merges dense short intervals, but not long ones", () => {
  expect(visible([0, 1, 2, 3, 4, 5, 50, 90, 91, 92], { start: 0, end: 100 }, 50)).toEqual([
    [0, 2.5, true],
    [25, 45, false],
    [45.5, 46, false],
  ]);
});

it("draws at most one interval for every two pixels", () => {
  const steps = Array.from({ length: 7200 }, (_, i) => [60 * i, 60 * i + 30]).flat();
  for (const length of [432_000, 100_000, 30_000]) {
    expect(visible(steps, { start: 0, end: length }, 1000).length).toBeLessThan(510);
  }
});

it("returns the first interval that ends after a frame", () => {
  const intervals = Uint32Array.of(0, 2, 4, 7);
  expect([0, 1, 2, 6, 7].map((frame) => firstIntervalAfter(intervals, frame))).toEqual([
    0, 0, 2, 2, 4,
  ]);
});
