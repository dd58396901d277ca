import { expect, test } from "vitest";
import { evenly } from "./evidence";

test("few places are all kept", () => {
  expect([...evenly(5, 512, 2)]).toEqual([0, 1, 2, 3, 4]);
  expect([...evenly(1, 512, 0)]).toEqual([0]);
  expect([...evenly(0, 512, 0)]).toEqual([]);
});

test("of many the ends and the one that matters are kept", () => {
  const found = evenly(864_000, 512, 123_457);
  expect(found.length).toBeLessThanOrEqual(512);
  expect(found[0]).toBe(0);
  expect(found.at(-1)).toBe(863_999);
  expect(found).toContain(123_457);
  expect([...found]).toEqual([...found].sort((a, b) => a - b));
});
