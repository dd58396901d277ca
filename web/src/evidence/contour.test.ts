import { expect, test } from "vitest";
import { contour } from "./contour";

test("a circle is found where it is, and its pieces join", () => {
  const size = 41;
  const values = Float32Array.from({ length: size * size }, (_, i) => {
    return 12 - Math.hypot((i % size) - 20, Math.floor(i / size) - 20);
  });
  const lines = contour(values, size, 0);
  const ends = new Map<string, number>();
  for (let i = 0; i < lines.length; i += 2) {
    const [x = 0, y = 0] = [lines[i], lines[i + 1]];
    expect(Math.hypot(x - 20, y - 20)).toBeCloseTo(12, 0);
    const key = `${x.toFixed(3)} ${y.toFixed(3)}`;
    ends.set(key, (ends.get(key) ?? 0) + 1);
  }
  expect(lines.length).toBeGreaterThan(4 * 60);
  expect([...ends.values()].every((count) => count === 2)).toBe(true);
});

test("a level that is nowhere has no lines", () => {
  expect(contour([1, 1, 1, 1], 2, 0)).toHaveLength(0);
  expect(contour([1, 1, 1, 1], 2, 2)).toHaveLength(0);
});

test("opposite corners are parted as their middle says", () => {
  const low = contour([1, -2, -2, 1], 2, 0);
  const high = contour([2, -1, -1, 2], 2, 0);
  expect([low.length, high.length]).toEqual([8, 8]);
  // The corner at the origin is cut off by itself, or goes on to the one across.
  const near = (line: Float32Array) => Math.max(...line.subarray(0, 4));
  expect(near(low)).toBeLessThan(0.5);
  expect(near(high)).toBe(1);
});
