/** Number of values per pair of extremes. */
const blockSize = 32;

/** Summary of a series, from which it is drawn at any zoom. */
export interface CurveSummary {
  /** Minimum and maximum of every block of values: min, max, min, max, …. */
  extremes: Float32Array;
  /** The 99.5th percentile, so that single spikes do not flatten the curve. */
  top: number;
}

export function summarizeCurve(values: Float32Array): CurveSummary {
  return { extremes: extremesOf(values), top: quantile(values, 0.995) };
}

/** Returns the minimum and maximum of every block of a series: min, max, min, max, …. */
export function extremesOf(values: Float32Array): Float32Array {
  const extremes = new Float32Array(2 * Math.ceil(values.length / blockSize));
  for (let start = 0, entry = 0; start < values.length; start += blockSize) {
    const end = Math.min(start + blockSize, values.length);
    let min = values[start] as number;
    let max = min;
    for (let i = start + 1; i < end; i++) {
      const value = values[i] as number;
      if (value < min) min = value;
      if (value > max) max = value;
    }
    extremes[entry++] = min;
    extremes[entry++] = max;
  }
  return extremes;
}

/**
 * Returns the minimum and maximum of a series in each pixel column: min, max, min, max, …. The cost
 * of drawing depends on the width of the canvas, not on the length of the clip.
 *
 * When zoomed out, blocks of `extremes` are read instead of values. Blocks may extend beyond a
 * column by at most a quarter of its width. Columns between two values repeat the earlier one.
 *
 * @param out Array to which the result is written.
 */
export function minMaxColumns(
  values: Float32Array,
  extremes: Float32Array,
  start: number,
  end: number,
  columns: number,
  out = new Float32Array(2 * columns),
): Float32Array {
  const perColumn = (end - start) / columns;
  const useBlocks = perColumn >= 4 * blockSize;
  // Entries are pairs of minimum and maximum, or single values that are both.
  const [series, stride, maxOffset, valuesPerEntry] = useBlocks
    ? [extremes, 2, 1, blockSize]
    : [values, 1, 0, 1];
  const last = series.length / stride - 1;
  for (let column = 0; column < columns; column++) {
    const from = clamp(Math.floor((start + column * perColumn) / valuesPerEntry), 0, last);
    const to = clamp(
      Math.ceil((start + (column + 1) * perColumn) / valuesPerEntry),
      from + 1,
      last + 1,
    );
    let min = series[stride * from] ?? 0;
    let max = series[stride * from + maxOffset] ?? 0;
    for (let i = from + 1; i < to; i++) {
      const low = series[stride * i] as number;
      const high = series[stride * i + maxOffset] as number;
      if (low < min) min = low;
      if (high > max) max = high;
    }
    out[2 * column] = min;
    out[2 * column + 1] = max;
  }
  return out;
}

/** Returns an approximate quantile, from at most about 4000 evenly spaced values. */
export function quantile(values: Float32Array, fraction: number): number {
  const stride = Math.max(1, Math.floor(values.length / 2000));
  const sample = new Float32Array(Math.ceil(values.length / stride));
  for (let i = 0; i < sample.length; i++) sample[i] = values[i * stride] as number;
  sample.sort();
  return sample[Math.min(sample.length - 1, Math.floor(fraction * sample.length))] ?? 0;
}

function clamp(value: number, low: number, high: number) {
  return value < low ? low : Math.min(value, high);
}
