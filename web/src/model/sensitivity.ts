/** The range of the sensitivity and its default. */
export const sensitivity = { min: 0.0002, max: 0.0044, default: 0.001 } as const;

/** Slider position 0 … 1 to r: equal steps of the hand are equal ratios of r. */
export function positionToR(position: number): number {
  const { min, max } = sensitivity;
  const r = min * (max / min) ** Math.min(Math.max(position, 0), 1);
  return Number(r.toFixed(4));
}

export function rToPosition(r: number): number {
  const { min, max } = sensitivity;
  return Math.log(Math.min(Math.max(r, min), max) / min) / Math.log(max / min);
}
