import { expect, it } from "vitest";
import { firstIndexWhere } from "./binary-search";

it("finds the first that is past", () => {
  const list = [1, 3, 3, 7];
  const past = (limit: number) => firstIndexWhere(list.length, (i) => (list[i] as number) > limit);
  expect([0, 1, 2, 3, 6, 7].map(past)).toEqual([0, 1, 1, 3, 3, 4]);
});

it("finds none where there is nothing", () => expect(firstIndexWhere(0, () => true)).toBe(0));
