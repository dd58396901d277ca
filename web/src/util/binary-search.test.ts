import { expect, it } from "vitest";
import { firstIndexWhere } from "./binary-search";

it("returns the first index for which the predicate is true", () => {
  const list = [1, 3, 3, 7];
  const firstAbove = (limit: number) =>
    firstIndexWhere(list.length, (i) => (list[i] as number) > limit);
  expect([0, 1, 2, 3, 6, 7].map(firstAbove)).toEqual([0, 1, 1, 3, 3, 4]);
});

it("returns 0 for an empty range", () => expect(firstIndexWhere(0, () => true)).toBe(0));
