/** Range and default of the sensitivity r. */
export const sensitivity = { min: 0.0002, max: 0.0044, default: 0.001 } as const;

/** Formats r with three significant digits. */
export const formatR = (r: number) => String(Number(r.toPrecision(3)));

/** Step of the slider position. */
export const positionStep = 0.005;

/**
 * Converts a slider position, 0 to 1, to r on a logarithmic scale. The rounding is finer than the steps of
 * the slider, so that every key press changes r. The position nearest to the default is the default.
 */
export function positionToR(position: number): number {
  const { min, max } = sensitivity;
  if (Math.abs(position - rToPosition(sensitivity.default)) <= positionStep / 2)
    return sensitivity.default;
  const r = min * (max / min) ** Math.min(Math.max(position, 0), 1);
  return Number(r.toPrecision(3));
}

/** Converts r to a slider position, 0 to 1. */
export function rToPosition(r: number): number {
  const { min, max } = sensitivity;
  return Math.log(Math.min(Math.max(r, min), max) / min) / Math.log(max / min);
}
