import { expect, test } from "vitest";
import { sampleIndices } from "./evidence-to-plain";

test("returns all indices if there are few", () => {
  expect([...sampleIndices(5, 512, 2)]).toEqual([0, 1, 2, 3, 4]);
  expect([...sampleIndices(1, 512, 0)]).toEqual([0]);
  expect([...sampleIndices(0, 512, 0)]).toEqual([]);
});

test("includes both ends and the extra index", () => {
  const indices = sampleIndices(864_000, 512, 123_457);
  expect(indices.length).toBeLessThanOrEqual(512);
  expect(indices[0]).toBe(0);
  expect(indices.at(-1)).toBe(863_999);
  expect(indices).toContain(123_457);
  expect([...indices]).toEqual([...indices].sort((a, b) => a - b));
});
