/** Steps of a ruler: a number at each major step, a tick at each minor one. */
export interface AxisSteps {
  major: number;
  minor: number;
}

const secondSteps: readonly AxisSteps[] = [
  { major: 0.01, minor: 0.002 },
  { major: 0.02, minor: 0.01 },
  { major: 0.05, minor: 0.01 },
  { major: 0.1, minor: 0.02 },
  { major: 0.2, minor: 0.1 },
  { major: 0.5, minor: 0.1 },
  { major: 1, minor: 0.2 },
  { major: 2, minor: 0.5 },
  { major: 5, minor: 1 },
  { major: 10, minor: 2 },
  { major: 30, minor: 5 },
  { major: 60, minor: 10 },
  { major: 120, minor: 30 },
  { major: 300, minor: 60 },
  { major: 600, minor: 120 },
  { major: 1800, minor: 300 },
  { major: 3600, minor: 600 },
];

/** Returns the finest steps whose numbers are at least `spacing` pixels apart. */
export function timeSteps(pixelsPerSecond: number, spacing = 72): AxisSteps {
  const fit = secondSteps.find((step) => step.major * pixelsPerSecond >= spacing);
  return fit ?? { major: 7200, minor: 1200 };
}

/** Formats a time on the ruler: `2.5 s`, `12 s`, `1:05`, `1:00:00`. */
export function rulerLabel(seconds: number, major: number): string {
  const digits = major >= 1 ? 0 : major >= 0.1 ? 1 : 2;
  if (seconds < 60) return `${seconds.toFixed(digits)} s`;
  const h = Math.floor(seconds / 3600);
  const m = Math.floor(seconds / 60) % 60;
  const s = (seconds % 60).toFixed(digits).padStart(digits ? digits + 3 : 2, "0");
  return h ? `${h}:${String(m).padStart(2, "0")}:${s}` : `${m}:${s}`;
}

/** Returns a round number at or above `value`, for the top of an axis. */
export function niceCeiling(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  for (const step of [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8]) {
    if (step * power >= value * 0.9999) return step * power;
  }
  return 10 * power;
}
