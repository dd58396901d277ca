import { expect, test } from "vitest";
import { stemOf, uniqueNames } from "./file-names";

test("removes the extension and makes names unique", () => {
  expect(uniqueNames(["a", "b", "A", "a", "a-2"])).toEqual(["a", "b", "A-2", "a-3", "a-2-2"]);
  expect(stemOf("Walk.BVH")).toBe("Walk");
  expect(stemOf("a.b.txt")).toBe("a.b.txt");
});
