/**
 * Returns the contour of a grid at a level, by marching squares: line segments as x and y of both
 * ends, in grid steps. `values` has size × size entries in row-major order (rows of equal y).
 */
export function contour(values: ArrayLike<number>, size: number, level: number): Float32Array {
  const segments: number[] = [];
  const valueAt = (x: number, y: number) => (values[y * size + x] as number) - level;
  for (let y = 0; y + 1 < size; y++) {
    for (let x = 0; x + 1 < size; x++) {
      const [a, b, c, d] = [
        valueAt(x, y),
        valueAt(x + 1, y),
        valueAt(x + 1, y + 1),
        valueAt(x, y + 1),
      ];
      const cornerMask = (a > 0 ? 1 : 0) | (b > 0 ? 2 : 0) | (c > 0 ? 4 : 0) | (d > 0 ? 8 : 0);
      if (cornerMask === 0 || cornerMask === 15) continue;
      const crossingAt: Record<Edge, () => [number, number]> = {
        bottom: () => [x + crossing(a, b), y],
        right: () => [x + 1, y + crossing(b, c)],
        top: () => [x + crossing(d, c), y + 1],
        left: () => [x, y + crossing(a, d)],
      };
      // Saddle: the mean at the centre decides whether the high corners are connected.
      const isCentreBelow = a + b + c + d <= 0;
      for (const [from, to] of crossedEdges(cornerMask, isCentreBelow))
        segments.push(...crossingAt[from](), ...crossingAt[to]());
    }
  }
  return Float32Array.from(segments);
}

type Edge = "bottom" | "right" | "top" | "left";

/** Edges crossed by the contour, by the mask of the corners above the level; complements are equal. */
const edgesByCorners: Record<number, readonly (readonly [Edge, Edge])[]> = {
  1: [["left", "bottom"]],
  2: [["bottom", "right"]],
  3: [["left", "right"]],
  4: [["right", "top"]],
  6: [["bottom", "top"]],
  7: [["left", "top"]],
};
// The two cases of a saddle: edges around the corners a and c, or around b and d.
const aroundAC = [edgesByCorners[1], edgesByCorners[4]].flatMap((line) => line ?? []);
const aroundBD = [edgesByCorners[2], edgesByCorners[7]].flatMap((line) => line ?? []);

/** Returns the pairs of edges that the contour crosses in a cell. */
function crossedEdges(
  cornerMask: number,
  isCentreBelow: boolean,
): readonly (readonly [Edge, Edge])[] {
  if (cornerMask === 5) return isCentreBelow ? aroundAC : aroundBD;
  if (cornerMask === 10) return isCentreBelow ? aroundBD : aroundAC;
  return edgesByCorners[cornerMask] ?? edgesByCorners[15 - cornerMask] ?? [];
}

/** Returns the position of the zero crossing between two values, 0 … 1. */
function crossing(a: number, b: number): number {
  return a === b ? 0.5 : a / (a - b);
}
