/** Paired measurements: two operations that alternate, so that both run under the same load. */

/** Half the width of the confidence interval of a ratio, relative to it, at which a measurement ends. */
const PRECISION = 0.03;
/** Time after which no further pair is measured for a narrower interval, in milliseconds. */
const MAX_TIME = 20_000;

/**
 * Measures two operations alternately, at least `count` times, until the ratio is known precisely or
 * the time is up. Each of `ours` and `reference` returns a time in milliseconds. The first pair warms up
 * and is left out.
 *
 * The end depends on the width of the interval only, not on a target, which would bias the result. The
 * interval then includes the true median in 93 to 95 % of simulated measurements.
 * @returns {Promise<{ ours: number, reference: number }[]>}
 */
export async function alternate(count, ours, reference) {
  const pairs = [];
  const end = performance.now() + MAX_TIME;
  const isDone = () => pairs.length >= count && (isPrecise(pairs) || performance.now() > end);
  for (let pair = 0; !isDone(); pair++) {
    // The order changes, so that neither always runs after the other.
    const times = {};
    for (const name of pair % 2 ? ["ours", "reference"] : ["reference", "ours"]) {
      times[name] = await (name === "ours" ? ours : reference)();
    }
    if (pair > 0) pairs.push(times);
  }
  return pairs;
}

/** Returns whether the confidence interval of the ratio of pairs is narrow. */
function isPrecise(pairs) {
  const { median, low, high } = medianInterval(
    pairs.map(({ ours, reference }) => ours / reference),
  );
  return high - low <= 2 * PRECISION * median;
}

/**
 * Returns the median of values and its 95 % confidence interval by order statistics; the whole range if
 * there are fewer than six values.
 */
export function medianInterval(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const count = sorted.length;
  const rank = Math.max(1, lowerRank(count));
  const middle = (sorted[Math.floor((count - 1) / 2)] + sorted[Math.ceil((count - 1) / 2)]) / 2;
  return { median: middle, low: sorted[rank - 1], high: sorted[count - rank] };
}

/** Returns the largest rank k such that the median lies below the k-th value in at most 2.5 % of cases. */
function lowerRank(count) {
  let [probability, sum, rank] = [0.5 ** count, 0, 0];
  while (sum + probability <= 0.025) {
    sum += probability;
    rank++;
    probability *= (count - rank + 1) / rank;
  }
  return rank;
}

/**
 * A row of the table.
 * @typedef {object} Row
 * @property {string} work
 * @property {string} reference
 * @property {number} ours Median.
 * @property {number} referenceValue Median.
 * @property {{ median: number, low: number, high: number }} ratio
 * @property {"at least" | "at most"} [bound]
 * @property {number} [target]
 * @property {(value: number) => string} [text] Formats `ours` and `referenceValue`; default as times.
 */

/** Returns a row on how many times as fast ours is as the reference. */
export const speedRow = (work, reference, pairs, target) => ({
  ...row(work, reference, pairs, ({ ours, reference }) => reference / ours),
  bound: "at least",
  target,
});

/** Returns a row on the time of ours as a multiple of that of the reference. */
export const timeRow = (work, reference, pairs, target) => ({
  ...row(work, reference, pairs, ({ ours, reference }) => ours / reference),
  bound: "at most",
  target,
});

function row(work, reference, pairs, ratioOf) {
  return {
    work,
    reference,
    ours: medianInterval(pairs.map(({ ours }) => ours)).median,
    referenceValue: medianInterval(pairs.map(({ reference }) => reference)).median,
    ratio: medianInterval(pairs.map(ratioOf)),
  };
}

/** Returns whether the whole interval of a row meets its target; undefined without a target. */
export function isMet({ ratio, bound, target }) {
  if (target === undefined) return undefined;
  return bound === "at least" ? ratio.low >= target : ratio.high <= target;
}
