import { expect, it } from "vitest";
import {
  cutsOf,
  nameSegments,
  renameSegment,
  type SegmentName,
  segmentAt,
  segmentFileNames,
  segmentIndexAt,
} from "./segments";
import type { Segment } from "./types";

/** Segments that tile a clip, from the frames at which they end. */
function tiles(...ends: number[]): Segment[] {
  return ends.map((end, i) => ({ start: ends[i - 1] ?? 0, end, kind: "action", label: "" }));
}

const namesOf = (segments: readonly Segment[], names: readonly SegmentName[]) =>
  nameSegments(segments, names).map(({ name }) => name);

it("keeps names where segments overlap by more than half, and only there", () => {
  const names = renameSegment(
    renameSegment([], { start: 0, end: 100 }, "walk"),
    { start: 100, end: 180 },
    "run",
  );
  expect(namesOf(tiles(100, 180), names)).toEqual(["walk", "run"]);
  expect(namesOf(tiles(60, 120, 180), names)).toEqual(["walk", "", "run"]);
  expect(namesOf(tiles(180), names)).toEqual(["walk"]);
  expect(namesOf(tiles(50, 140, 180), names)).toEqual(["", "", ""]);
});

it("remembers the names of a segmentation that comes back", () => {
  const names = renameSegment([], { start: 0, end: 100 }, "walk");
  expect(namesOf(tiles(30, 60, 100), names)).toEqual(["", "", ""]);
  expect(namesOf(tiles(100), names)).toEqual(["walk"]);
});

it("takes a new name for the one before it, also after the cuts have moved", () => {
  let names = renameSegment([], { start: 0, end: 100 }, "walk");
  names = renameSegment(names, { start: 0, end: 80 }, "stroll");
  expect(namesOf(tiles(100), names)).toEqual(["stroll"]);
  expect(renameSegment(names, { start: 0, end: 90 }, " ")).toEqual([]);
});

it("finds the segment at a frame", () => {
  const actions = nameSegments(tiles(10, 25, 40), []);
  expect([0, 9, 10, 24, 39, 99].map((frame) => segmentIndexAt(actions, frame))).toEqual([
    0, 0, 1, 1, 2, 2,
  ]);
  expect(segmentAt(actions, 12)?.number).toBe(2);
  expect(segmentAt([], 3)).toBeUndefined();
  expect(cutsOf(actions)).toEqual([10, 25]);
});

it("makes file names that any system takes", () => {
  const names = renameSegment([], { start: 10, end: 25 }, " a/b: “turn”? ");
  expect(segmentFileNames(nameSegments(tiles(10, 25), names), "walk")).toEqual([
    "walk-01.bvh",
    "walk-02-a-b-turn.bvh",
  ]);
});
