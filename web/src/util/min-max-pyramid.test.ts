import { expect, it } from "vitest";
import { extremesOf, minMaxColumns, quantile } from "./min-max-pyramid";

it("preserves every peak and trough of many frames", () => {
  const values = Float32Array.from({ length: 1000 }, (_, i) =>
    i === 437 ? 9 : i === 611 ? -9 : 0,
  );
  const columns = minMaxColumns(values, extremesOf(values), 0, 1000, 10);
  expect(columns[2 * 4 + 1]).toBe(9);
  expect(columns[2 * 6]).toBe(-9);
  expect(columns[0]).toBe(0);
});

it("repeats values that are wider than a column", () => {
  const values = Float32Array.of(1, 2);
  const columns = minMaxColumns(values, extremesOf(values), 0, 2, 8);
  expect([...columns]).toEqual([1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2]);
});

it("covers all values of a column and none further than a quarter of a column away", () => {
  const values = Float32Array.from({ length: 10_007 }, (_, i) => Math.sin(i * i));
  for (const [start, end] of [
    [0, 10_007],
    [3.5, 9_000.25],
    [-200, 10_100],
  ] as const) {
    const columns = minMaxColumns(values, extremesOf(values), start, end, 50);
    const columnWidth = (end - start) / 50;
    const within = (from: number, to: number) =>
      values.slice(Math.max(0, Math.floor(from)), Math.max(0, Math.ceil(to)));
    for (let column = 0; column < 50; column++) {
      const [from, to] = [start + column * columnWidth, start + (column + 1) * columnWidth];
      const inside = within(from, to);
      if (!inside.length) continue;
      const around = within(from - columnWidth / 4, to + columnWidth / 4);
      const [min, max] = columns.slice(2 * column, 2 * column + 2);
      expect(min).toBeLessThanOrEqual(Math.min(...inside));
      expect(min).toBeGreaterThanOrEqual(Math.min(...around));
      expect(max).toBeGreaterThanOrEqual(Math.max(...inside));
      expect(max).toBeLessThanOrEqual(Math.max(...around));
    }
  }
});

it("does not read outside the series", () => {
  const values = Float32Array.of(3, 4);
  const columns = minMaxColumns(values, extremesOf(values), -2, 4, 3);
  expect([...columns].every(Number.isFinite)).toBe(true);
});

it("returns a quantile", () => {
  expect(quantile(Float32Array.of(5, 1, 3, 2, 4), 0.5)).toBe(3);
  expect(quantile(new Float32Array(0), 0.5)).toBe(0);
});
