/**
 * Where a grid of values crosses a level, by marching squares: pieces of line, x and y of both
 * ends each, in steps of the grid. `values` are size × size, by rows of one y.
 */
export function contour(values: ArrayLike<number>, size: number, level: number): Float32Array {
  const found: number[] = [];
  const at = (x: number, y: number) => (values[y * size + x] as number) - level;
  for (let y = 0; y + 1 < size; y++) {
    for (let x = 0; x + 1 < size; x++) {
      const [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
      const corners = (a > 0 ? 1 : 0) | (b > 0 ? 2 : 0) | (c > 0 ? 4 : 0) | (d > 0 ? 8 : 0);
      if (corners === 0 || corners === 15) continue;
      const sides: Record<Edge, () => [number, number]> = {
        low: () => [x + crossing(a, b), y],
        right: () => [x + 1, y + crossing(b, c)],
        high: () => [x + crossing(d, c), y + 1],
        left: () => [x, y + crossing(a, d)],
      };
      // Opposite corners above the level: the middle says whether they hang together.
      const hollow = a + b + c + d <= 0;
      for (const [from, to] of edges(corners, hollow)) found.push(...sides[from](), ...sides[to]());
    }
  }
  return Float32Array.from(found);
}

type Edge = "low" | "right" | "high" | "left";

const lines: Record<number, readonly (readonly [Edge, Edge])[]> = {
  1: [["left", "low"]],
  2: [["low", "right"]],
  3: [["left", "right"]],
  4: [["right", "high"]],
  6: [["low", "high"]],
  7: [["left", "high"]],
};
const apart = [lines[1], lines[4]].flatMap((line) => line ?? []);
const acrossThem = [lines[2], lines[7]].flatMap((line) => line ?? []);

/** The edges that the level passes through, by the corners above it. */
function edges(corners: number, hollow: boolean): readonly (readonly [Edge, Edge])[] {
  if (corners === 5) return hollow ? apart : acrossThem;
  if (corners === 10) return hollow ? acrossThem : apart;
  return lines[corners] ?? lines[15 - corners] ?? [];
}

/** How far from a to b zero lies, 0 … 1. */
function crossing(a: number, b: number): number {
  return a === b ? 0.5 : a / (a - b);
}
