/**
 * Least and greatest value of a series under each pixel column, so that a curve costs
 * as much to draw as the canvas is wide, however long the clip. `out` holds min, max,
 * min, max …; columns nobody falls in repeat the sample they lie on.
 */
export function minMaxColumns(
  values: Float32Array,
  start: number,
  end: number,
  columns: number,
  out = new Float32Array(2 * columns),
): Float32Array {
  const perColumn = (end - start) / columns;
  const last = values.length - 1;
  for (let column = 0; column < columns; column++) {
    const from = clamp(Math.floor(start + column * perColumn), 0, last);
    const to = clamp(Math.ceil(start + (column + 1) * perColumn) - 1, from, last);
    let min = values[from] ?? 0;
    let max = min;
    for (let i = from + 1; i <= to; i++) {
      const value = values[i] ?? 0;
      if (value < min) min = value;
      if (value > max) max = value;
    }
    out[2 * column] = min;
    out[2 * column + 1] = max;
  }
  return out;
}

/** The value below which `share` of a series lies, from an even sample of it: one spike must not flatten a curve. */
export function quantile(values: Float32Array, share: number): number {
  const stride = Math.max(1, Math.floor(values.length / 2000));
  const sample = values.filter((_, i) => i % stride === 0).sort();
  return sample[Math.min(sample.length - 1, Math.floor(share * sample.length))] ?? 0;
}

function clamp(value: number, low: number, high: number) {
  return value < low ? low : Math.min(value, high);
}
