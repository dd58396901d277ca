import { expect, it } from "vitest";
import { type AnyEdit, addCut, cutEditsOf, moveCut, nearestCut, plantEditsOf } from "./cut-edits";

it("moves a cut between its neighbours", () => {
  const move = (from: number, to: number) => moveCut([40, 100], from, to, 120);
  expect(move(40, 55)).toEqual([
    { cut: 40, present: false },
    { cut: 55, present: true },
  ]);
  expect(move(40, 300).at(-1)).toEqual({ cut: 99, present: true });
  expect(move(100, 7).at(-1)).toEqual({ cut: 41, present: true });
  expect(move(100, 500).at(-1)).toEqual({ cut: 119, present: true });
  expect(move(40, 40)).toEqual([]);
  expect(move(41, 50)).toEqual([]);
});

it("adds cuts inside the clip only", () => {
  expect(addCut([40], 60, 120)).toEqual([{ cut: 60, present: true }]);
  for (const frame of [0, 40, 120]) expect(addCut([40], frame, 120)).toEqual([]);
});

it("finds the nearest cut", () => {
  expect(nearestCut([40, 100], 71)).toBe(100);
  expect(nearestCut([40, 100], 2)).toBe(40);
  expect(nearestCut([], 2)).toBeUndefined();
});

it("separates edits of plants and of cuts", () => {
  const plant = { side: "left", part: "toe", start: 1, end: 2, planted: true } as const;
  const cut = { cut: 4, present: true };
  const edits: AnyEdit[] = [plant, cut];
  expect(plantEditsOf(edits)).toEqual([plant]);
  expect(cutEditsOf(edits)).toEqual([cut]);
});
