import { expect, test } from "vitest";
import { contour } from "./contour";

test("returns the closed contour of a circle", () => {
  const size = 41;
  const values = Float32Array.from({ length: size * size }, (_, i) => {
    return 12 - Math.hypot((i % size) - 20, Math.floor(i / size) - 20);
  });
  const contourLines = contour(values, size, 0);
  const endCounts = new Map<string, number>();
  for (let i = 0; i < contourLines.length; i += 2) {
    const [x = 0, y = 0] = [contourLines[i], contourLines[i + 1]];
    expect(Math.hypot(x - 20, y - 20)).toBeCloseTo(12, 0);
    const key = `${x.toFixed(3)} ${y.toFixed(3)}`;
    endCounts.set(key, (endCounts.get(key) ?? 0) + 1);
  }
  expect(contourLines.length).toBeGreaterThan(4 * 60);
  expect([...endCounts.values()].every((count) => count === 2)).toBe(true);
});

test("returns no lines for a level outside the values", () => {
  expect(contour([1, 1, 1, 1], 2, 0)).toHaveLength(0);
  expect(contour([1, 1, 1, 1], 2, 2)).toHaveLength(0);
});

test("resolves saddles by the value at the centre", () => {
  const below = contour([1, -2, -2, 1], 2, 0);
  const above = contour([2, -1, -1, 2], 2, 0);
  expect([below.length, above.length]).toEqual([8, 8]);
  // The corner at the origin is cut off alone, or connected to the opposite corner.
  const farthest = (line: Float32Array) => Math.max(...line.subarray(0, 4));
  expect(farthest(below)).toBeLessThan(0.5);
  expect(farthest(above)).toBe(1);
});
