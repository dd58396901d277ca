import { expect, test } from "vitest";
import { baseNameOf, isMacCompanion, safeFileName, stemOf, uniqueNames } from "./file-names";

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

test("makes names unique for systems that compose accents", () => {
  expect(uniqueNames(["é", "e\u0301", "É"])).toEqual(["é", "e\u0301-2", "É-3"]);
});

test("returns the last part of paths of any system", () => {
  expect(baseNameOf("a/b/walk.bvh")).toBe("walk.bvh");
  expect(baseNameOf("..\\..\\walk.bvh")).toBe("walk.bvh");
  expect(baseNameOf("C:\\Users\\walk.bvh")).toBe("walk.bvh");
  expect(baseNameOf("folder/")).toBe("");
});

test.each([
  ["walk.bvh", "walk.bvh"],
  ["Läufer 走る.bvh", "Läufer 走る.bvh"],
  ["../../etc/passwd", "passwd"],
  ["..\\..\\win", "win"],
  ["C:\\Users\\x.bvh", "x.bvh"],
  ["c:x.bvh", "x.bvh"],
  ["..", "clip"],
  ["", "clip"],
  ["///", "clip"],
  ['a<b>:"c|d?e*', "a_b___c_d_e_"],
  ["new\nline\u0000\u001b[31m", "new_line__[31m"],
  ["evil\u202efdp.bvh", "evil_fdp.bvh"],
  ["walk. . .", "walk"],
  ["  walk", "walk"],
  ["-rf.bvh", "_rf.bvh"],
  ["CON", "_CON"],
  ["con.bvh", "_con.bvh"],
  ["Nul .txt", "_Nul .txt"],
  ["COM1.plants.json", "_COM1.plants.json"],
  ["lpt³", "_lpt³"],
  ["CONIN$", "_CONIN$"],
  ["console.bvh", "console.bvh"],
  ["com10.bvh", "com10.bvh"],
  ["\ud800walk", "\ufffdwalk"],
])("makes the file name %j safe for every system", (name, safe) => {
  expect(safeFileName(name)).toBe(safe);
  expect(safeFileName(safe)).toBe(safe);
});

test("shortens long names and preserves their extension", () => {
  const name = safeFileName(`${"走".repeat(1000)}.plants.json`);
  expect(new TextEncoder().encode(name).length).toBeLessThanOrEqual(200);
  expect(name).toMatch(/^走+….*\.plants\.json$/);
});
