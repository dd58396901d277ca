import { expect, it } from "vitest";
import { firstIntervalAfter } from "../model/intervals";
import { forEachVisible } from "./visible-intervals";

const found = (intervals: number[], view: { start: number; end: number }, width: number) => {
  const list: [number, number, boolean][] = [];
  forEachVisible(Uint32Array.from(intervals), view, width, (...bar) => list.push(bar));
  return list;
};

it("hands over intervals that can be told apart one by one", () => {
  expect(found([10, 14, 15, 20], { start: 0, end: 64 }, 64)).toEqual([
    [10, 14, false],
    [15, 20, false],
  ]);
});

it("leaves out what is out of sight", () => {
  expect(found([0, 5, 8, 12, 30, 40], { start: 6, end: 26 }, 20)).toEqual([[2, 6, false]]);
});

it("makes one of a crowd, and leaves long ones out of it", () => {
  expect(found([0, 1, 2, 3, 4, 5, 50, 90, 91, 92], { start: 0, end: 100 }, 50)).toEqual([
    [0, 2.5, true],
    [25, 45, false],
    [45.5, 46, false],
  ]);
});

it("never hands over more than there is room for", () => {
  const steps = Array.from({ length: 7200 }, (_, i) => [60 * i, 60 * i + 30]).flat();
  for (const length of [432_000, 100_000, 30_000]) {
    expect(found(steps, { start: 0, end: length }, 1000).length).toBeLessThan(510);
  }
});

it("finds the first interval that ends after a frame", () => {
  const intervals = Uint32Array.of(0, 2, 4, 7);
  expect([0, 1, 2, 6, 7].map((frame) => firstIntervalAfter(intervals, frame))).toEqual([
    0, 0, 2, 2, 4,
  ]);
});
