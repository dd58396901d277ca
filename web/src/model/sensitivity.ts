/** Range and default of the sensitivity r. */
export const sensitivity = { min: 0.0002, max: 0.0044, default: 0.001 } as const;

/** Converts a slider position, 0 to 1, to r on a logarithmic scale. */
export function positionToR(position: number): number {
  const { min, max } = sensitivity;
  const r = min * (max / min) ** Math.min(Math.max(position, 0), 1);
  return Number(r.toFixed(4));
}

/** Converts r to a slider position, 0 to 1. */
export function rToPosition(r: number): number {
  const { min, max } = sensitivity;
  return Math.log(Math.min(Math.max(r, min), max) / min) / Math.log(max / min);
}
