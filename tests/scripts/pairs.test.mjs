import assert from "node:assert/strict";
import { test } from "node:test";
import { alternate, isMet, medianInterval, speedRow, timeRow } from "../../scripts/bench/pairs.mjs";

const upTo = (count) => Array.from({ length: count }, (_, i) => count - i);

test("the interval of a median has the ranks of the binomial distribution", () => {
  // Tables of the sign test: 95 % intervals by order statistics.
  for (const [count, low, high] of [
    [6, 1, 6],
    [8, 1, 8],
    [9, 2, 8],
    [15, 4, 12],
    [25, 8, 18],
  ]) {
    const { median, ...interval } = medianInterval(upTo(count));
    assert.deepEqual(interval, { low, high }, `${count} values`);
    assert.equal(median, (count + 1) / 2);
  }
  assert.deepEqual(medianInterval([3, 1, 2]), { median: 2, low: 1, high: 3 });
});

test("a target is met by the whole interval only", () => {
  const pairs = upTo(9).map((reference) => ({ ours: 2, reference }));
  // The ratios are 0.5 to 4.5, and the interval is 1 to 4.
  assert.deepEqual(speedRow("", "", pairs, 1).ratio, { median: 2.5, low: 1, high: 4 });
  assert.equal(isMet(speedRow("", "", pairs, 1)), true);
  assert.equal(isMet(speedRow("", "", pairs, 1.1)), false);
  assert.equal(isMet(timeRow("", "", pairs, 1)), true);
  assert.equal(isMet(timeRow("", "", pairs, 0.9)), false);
  assert.equal(isMet(speedRow("", "", pairs)), undefined);
});

test("operations alternate, and the first pair is left out", async () => {
  const order = [];
  const measure = (name) => async () => order.push(name);
  const pairs = await alternate(2, measure("ours"), measure("reference"));
  assert.deepEqual(order, ["reference", "ours", "ours", "reference", "reference", "ours"]);
  assert.deepEqual(pairs, [
    { ours: 3, reference: 4 },
    { ours: 6, reference: 5 },
  ]);
});
