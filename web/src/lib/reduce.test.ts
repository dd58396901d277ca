import { expect, it } from "vitest";
import { minMaxColumns, quantile } from "./reduce";

it("keeps every peak and trough of many frames", () => {
  const values = Float32Array.from({ length: 1000 }, (_, i) =>
    i === 437 ? 9 : i === 611 ? -9 : 0,
  );
  const columns = minMaxColumns(values, 0, 1000, 10);
  expect(columns[2 * 4 + 1]).toBe(9);
  expect(columns[2 * 6]).toBe(-9);
  expect(columns[0]).toBe(0);
});

it("repeats a frame that is wider than a column", () => {
  const columns = minMaxColumns(Float32Array.of(1, 2), 0, 2, 8);
  expect([...columns]).toEqual([1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2]);
});

it("does not read outside the series", () => {
  const columns = minMaxColumns(Float32Array.of(3, 4), -2, 4, 3);
  expect([...columns].every(Number.isFinite)).toBe(true);
});

it("finds a quantile", () => {
  expect(quantile(Float32Array.of(5, 1, 3, 2, 4), 0.5)).toBe(3);
  expect(quantile(new Float32Array(0), 0.5)).toBe(0);
});
