import { expect, test } from "vitest";
import { sampleIndices } from "./evidence-to-plain";

test("few places are all kept", () => {
  expect([...sampleIndices(5, 512, 2)]).toEqual([0, 1, 2, 3, 4]);
  expect([...sampleIndices(1, 512, 0)]).toEqual([0]);
  expect([...sampleIndices(0, 512, 0)]).toEqual([]);
});

test("of many the ends and the one that matters are kept", () => {
  const found = sampleIndices(864_000, 512, 123_457);
  expect(found.length).toBeLessThanOrEqual(512);
  expect(found[0]).toBe(0);
  expect(found.at(-1)).toBe(863_999);
  expect(found).toContain(123_457);
  expect([...found]).toEqual([...found].sort((a, b) => a - b));
});
