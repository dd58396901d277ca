import { expect, test } from "vitest";
import { columns, filterRows, haveSameOptions, sortRows, type TableRow, tableCsv } from "./table";

const summary = (frames: number) => ({
  frames,
  rate: 120,
  notices: 0,
  plants: 3,
  planted: { left: 0.5, right: 2 / 3 },
  missing: [],
  edited: false,
  elapsedMs: 12,
});

const rows: TableRow[] = [
  { number: 1, source: { name: "walk 10.bvh" }, status: "done", summary: summary(20) },
  {
    number: 2,
    source: { name: "walk 9.bvh" },
    status: "failed",
    failure: { message: 'no "feet"' },
  },
  { number: 3, source: { name: "jump, high.bvh" }, status: "done", summary: summary(100) },
];

const numbers = (list: readonly TableRow[]) => list.map(({ number }) => number);

test("sorts by value, names in natural order, and missing values last", () => {
  expect(numbers(sortRows(rows, "frames", 1))).toEqual([1, 3, 2]);
  expect(numbers(sortRows(rows, "frames", -1))).toEqual([3, 1, 2]);
  expect(numbers(sortRows(rows, "file", 1))).toEqual([3, 2, 1]);
  expect(numbers(sortRows(rows, "", 1))).toEqual([1, 2, 3]);
});

test("filters by all words", () => {
  expect(numbers(filterRows(rows, "WALK 9"))).toEqual([2]);
  expect(numbers(filterRows(rows, "feet failed"))).toEqual([2]);
  expect(numbers(filterRows(rows, " "))).toEqual([1, 2, 3]);
});

test("exports CSV with quoted fields", () => {
  const [header, first, second, third] = tableCsv(rows).split("\n");
  expect(header).toMatch(/^file,frames,rate_hz,duration_s,.*,took_ms,error,saved_as$/);
  expect(first).toMatch(/^walk 10\.bvh,20,120,0\.1667,0,3,,no,,0\.5,0\.6667,/);
  expect(second).toMatch(/^walk 9\.bvh,,,.*,"no ""feet""",$/);
  expect(third).toMatch(/^"jump, high\.bvh",100,/);
  expect(new Set([header, first].map((line) => line?.split(",").length)).size).toBe(1);
});

test("clips of the same name are told apart by their titles, also in what is saved", () => {
  const [walk] = rows;
  if (!walk) throw new Error("There is no row.");
  const inFolder = (title: string) => ({ ...walk, source: { name: "walk.bvh", title } });
  const both = [inFolder("a/walk.bvh"), inFolder("b/walk.bvh")];
  expect(both.map((row) => columns[0]?.text(row))).toEqual(["a/walk.bvh", "b/walk.bvh"]);
  expect(filterRows(both, "b/")).toEqual([both[1]]);
  const savedAs = new Map(both.map((row, i) => [row, ["walk", "walk-2"][i] ?? ""]));
  const [, first, second] = tableCsv(both, savedAs).split("\n");
  expect(first).toMatch(/^a\/walk\.bvh,.*,walk$/);
  expect(second).toMatch(/^b\/walk\.bvh,.*,walk-2$/);
});

test("a displayed number is rounded once", () => {
  const skate = { mean: 0.007493, worst: 0.02049 };
  const row = { number: 1, source: { name: "hop.bvh" }, status: "done" as const };
  const texts = columns.map(({ text }) => text({ ...row, summary: { ...summary(20), skate } }));
  expect(texts).toEqual(expect.arrayContaining(["0.7 cm", "2.0 cm"]));
  expect(tableCsv([{ ...row, summary: { ...summary(20), skate } }])).toContain(",0.0075,0.0205,");
});

test("options are the same if all their values are, in any order", () => {
  const request = { detect: { method: "robust", r: 1, w: 1 }, segment: { method: "auto" } };
  const detect = { w: 1, r: 1, method: "robust" };
  expect(haveSameOptions(request, { ...request, detect })).toBe(true);
  expect(haveSameOptions(request, { ...request, detect: { ...detect, method: "paper" } })).toBe(
    false,
  );
  expect(haveSameOptions(request, { ...request, segment: { method: "pca" } })).toBe(false);
  expect(haveSameOptions(request, { ...request, segment: { method: "auto", dims: 2 } })).toBe(
    false,
  );
});
