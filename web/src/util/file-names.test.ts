import { expect, test } from "vitest";
import { isMacCompanion, stemOf, uniqueNames } from "./file-names";

test("removes the extension and makes names unique", () => {
  expect(uniqueNames(["a", "b", "A", "a", "a-2"])).toEqual(["a", "b", "A-2", "a-3", "a-2-2"]);
  expect(stemOf("Walk.BVH")).toBe("Walk");
  expect(stemOf("a.b.txt")).toBe("a.b.txt");
});

test("recognises the companion files of macOS", () => {
  const companions = ["._walk.bvh", "take 1/._walk.bvh", "__MACOSX", "__MACOSX/walk.bvh"];
  expect(companions.every(isMacCompanion)).toBe(true);
  expect(["walk.bvh", "a._b.bvh", "MACOSX/walk.bvh", "_.bvh"].some(isMacCompanion)).toBe(false);
});
