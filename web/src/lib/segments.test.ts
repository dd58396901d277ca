import { expect, it } from "vitest";
import type { Segment } from "../worker/types";
import { actionAt, actionsOf, cutsOf, fileNames, type Named, placeAt, renamed } from "./segments";

/** Segments that tile a clip, from the frames at which they end. */
function tiles(...ends: number[]): Segment[] {
  return ends.map((end, i) => ({ start: ends[i - 1] ?? 0, end, kind: "action", label: "" }));
}

const namesOf = (segments: readonly Segment[], names: readonly Named[]) =>
  actionsOf(segments, names).map(({ name }) => name);

it("keeps names where segments overlap by more than half, and only there", () => {
  const names = renamed(
    renamed([], { start: 0, end: 100 }, "walk"),
    { start: 100, end: 180 },
    "run",
  );
  expect(namesOf(tiles(100, 180), names)).toEqual(["walk", "run"]);
  expect(namesOf(tiles(60, 120, 180), names)).toEqual(["walk", "", "run"]);
  expect(namesOf(tiles(180), names)).toEqual(["walk"]);
  expect(namesOf(tiles(50, 140, 180), names)).toEqual(["", "", ""]);
});

it("remembers the names of a segmentation that comes back", () => {
  const names = renamed([], { start: 0, end: 100 }, "walk");
  expect(namesOf(tiles(30, 60, 100), names)).toEqual(["", "", ""]);
  expect(namesOf(tiles(100), names)).toEqual(["walk"]);
});

it("takes a new name for the one before it, also after the cuts have moved", () => {
  let names = renamed([], { start: 0, end: 100 }, "walk");
  names = renamed(names, { start: 0, end: 80 }, "stroll");
  expect(namesOf(tiles(100), names)).toEqual(["stroll"]);
  expect(renamed(names, { start: 0, end: 90 }, " ")).toEqual([]);
});

it("finds the segment at a frame", () => {
  const actions = actionsOf(tiles(10, 25, 40), []);
  expect([0, 9, 10, 24, 39, 99].map((frame) => placeAt(actions, frame))).toEqual([
    0, 0, 1, 1, 2, 2,
  ]);
  expect(actionAt(actions, 12)?.number).toBe(2);
  expect(actionAt([], 3)).toBeUndefined();
  expect(cutsOf(actions)).toEqual([10, 25]);
});

it("makes file names that any system takes", () => {
  const names = renamed([], { start: 10, end: 25 }, " a/b: “turn”? ");
  expect(fileNames(actionsOf(tiles(10, 25), names), "walk")).toEqual([
    "walk-01.bvh",
    "walk-02-a-b-turn.bvh",
  ]);
});
