/** Least distance between two ticks, as a fraction of the axis length. */
const minSpacing = 0.15;

/** Returns round ticks from 0 to `max` for an axis with a square-root scale. */
export function sqrtTicks(max: number): number[] {
  const ticks = [max];
  let lastPosition = 1;
  for (let power = 10 ** Math.ceil(Math.log10(max)); power > max * 1e-4; power /= 10) {
    for (const step of [5, 2, 1]) {
      const tick = Number((step * power).toPrecision(1));
      const position = Math.sqrt(tick / max);
      if (tick >= max || lastPosition - position < minSpacing || position < minSpacing) continue;
      ticks.unshift(tick);
      lastPosition = position;
    }
  }
  return [0, ...ticks];
}
