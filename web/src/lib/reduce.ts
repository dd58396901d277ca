/** Values whose extremes are known together. */
const step = 32;

/** Least and greatest value of every 32 of a series: min, max, min, max … */
export function extremesOf(values: Float32Array): Float32Array {
  const extremes = new Float32Array(2 * Math.ceil(values.length / step));
  for (let start = 0, entry = 0; start < values.length; start += step) {
    const end = Math.min(start + step, values.length);
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
 * Least and greatest value of a series under each pixel column, so that a curve costs
 * as much to draw as the canvas is wide, however long the clip: from afar it is read
 * from its extremes. `out` holds min, max, min, max …; columns nobody
 * falls in repeat the sample they lie on.
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
  const last = values.length - 1;
  const isFar = perColumn > 2 * step;
  for (let column = 0; column < columns; column++) {
    const from = clamp(Math.floor(start + column * perColumn), 0, last);
    const to = clamp(Math.ceil(start + (column + 1) * perColumn), from + 1, last + 1);
    let min = values[from] ?? 0;
    let max = min;
    for (let i = from; i < to; ) {
      let low = values[i] as number;
      let high = low;
      if (isFar && i % step === 0 && i + step <= to) {
        low = extremes[(2 * i) / step] as number;
        high = extremes[(2 * i) / step + 1] as number;
        i += step;
      } else i++;
      if (low < min) min = low;
      if (high > max) max = high;
    }
    out[2 * column] = min;
    out[2 * column + 1] = max;
  }
  return out;
}

/** The value below which `share` of a series lies, from an even sample of it: one spike must not flatten a curve. */
export function quantile(values: Float32Array, share: number): number {
  const stride = Math.max(1, Math.floor(values.length / 2000));
  const sample = new Float32Array(Math.ceil(values.length / stride));
  for (let i = 0; i < sample.length; i++) sample[i] = values[i * stride] as number;
  sample.sort();
  return sample[Math.min(sample.length - 1, Math.floor(share * sample.length))] ?? 0;
}

function clamp(value: number, low: number, high: number) {
  return value < low ? low : Math.min(value, high);
}
