import { firstIndexWhere } from "../../util/binary-search";
import type { Side, Step } from "../types";

/** Returns the position of a time, in seconds, in the gait cycle of one foot, in percent; undefined outside of strides that count. */
export function percentOfCycle(
  steps: readonly Step[],
  side: Side,
  time: number,
): number | undefined {
  const after = firstIndexWhere(steps.length, (i) => (steps[i]?.strike ?? 0) > time);
  const step = steps.slice(0, after).findLast((other) => other.side === side);
  if (!step?.stride) return undefined;
  const percent = (100 * (time - step.strike)) / step.stride.time;
  return percent <= 100 ? percent : undefined;
}

/** Returns the value of a curve with a point per percent; undefined if there is no curve. */
export function valueAtPercent(mean: readonly number[] | undefined, percent: number) {
  const index = Math.min(Math.floor(percent), 99);
  const [from, to] = [mean?.[index], mean?.[index + 1]];
  if (from === undefined || to === undefined) return undefined;
  return from + (percent - index) * (to - from);
}
