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
  const measure = (name, times) => async () => {
    order.push(name);
    return times.shift();
  };
  const pairs = await alternate(2, measure("ours", [9, 3, 3]), measure("reference", [1, 4, 4]));
  assert.deepEqual(order, ["reference", "ours", "ours", "reference", "reference", "ours"]);
  assert.deepEqual(pairs, [
    { ours: 3, reference: 4 },
    { ours: 3, reference: 4 },
  ]);
});

test("pairs are measured until the interval of the ratio is narrow", async () => {
  // Two of ten pairs are disturbed; the interval of few pairs includes them.
  const times = Array.from({ length: 100 }, (_, pair) => (pair % 10 < 2 ? 200 : 100));
  const pairs = await alternate(
    3,
    async () => times.shift(),
    async () => 100,
  );
  const { median, low, high } = medianInterval(pairs.map(({ ours }) => ours));
  assert.ok(pairs.length > 3 && pairs.length < 20, `${pairs.length} pairs`);
  assert.deepEqual([median, low, high], [100, 100, 100]);
});
