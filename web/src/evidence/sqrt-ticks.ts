/** Least distance of two numbers on an axis, as a share of it. */
const apart = 0.15;

/** Round numbers for an axis from 0 to `top` on which places are the roots of shares. */
export function squareTicks(top: number): number[] {
  const ticks = [top];
  let last = 1;
  for (let power = 10 ** Math.ceil(Math.log10(top)); power > top * 1e-4; power /= 10) {
    for (const step of [5, 2, 1]) {
      const tick = Number((step * power).toPrecision(1));
      const share = Math.sqrt(tick / top);
      if (tick >= top || last - share < apart || share < apart) continue;
      ticks.unshift(tick);
      last = share;
    }
  }
  return [0, ...ticks];
}
