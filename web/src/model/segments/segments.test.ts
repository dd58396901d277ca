import { expect, it } from "vitest";
import type { Segment } from "../types";
import { segmentFileNames } from "./file-names";
import {
  actionsOf,
  cutsOf,
  nameSegments,
  renameSegment,
  type SegmentName,
  segmentAt,
  segmentIndexAt,
} from "./segments";

/** Returns consecutive segments from the frames at which they end. */
function segmentsEndingAt(...ends: number[]): Segment[] {
  return ends.map((end, i) => ({ start: ends[i - 1] ?? 0, end, kind: "action", label: "" }));
}

const namesOf = (segments: readonly Segment[], names: readonly SegmentName[]) =>
  nameSegments(segments, names).map(({ name }) => name);

it("preserves names of segments that overlap by more than half, and no others", () => {
  const names = renameSegment(
    renameSegment([], { start: 0, end: 100 }, "walk"),
    { start: 100, end: 180 },
    "run",
  );
  expect(namesOf(segmentsEndingAt(100, 180), names)).toEqual(["walk", "run"]);
  expect(namesOf(segmentsEndingAt(60, 120, 180), names)).toEqual(["walk", "", "run"]);
  expect(namesOf(segmentsEndingAt(180), names)).toEqual(["walk"]);
  expect(namesOf(segmentsEndingAt(50, 140, 180), names)).toEqual(["", "", ""]);
});

it("restores the names of an earlier segmentation", () => {
  const names = renameSegment([], { start: 0, end: 100 }, "walk");
  expect(namesOf(segmentsEndingAt(30, 60, 100), names)).toEqual(["", "", ""]);
  expect(namesOf(segmentsEndingAt(100), names)).toEqual(["walk"]);
});

it("replaces the name of an action, also if its cuts have moved", () => {
  let names = renameSegment([], { start: 0, end: 100 }, "walk");
  names = renameSegment(names, { start: 0, end: 80 }, "stroll");
  expect(namesOf(segmentsEndingAt(100), names)).toEqual(["stroll"]);
  expect(renameSegment(names, { start: 0, end: 90 }, " ")).toEqual([]);
});

it("gives the name of an action to all its segments, except those with a name of their own", () => {
  const actions = ["A", "B", "A", "A"];
  const segments = segmentsEndingAt(10, 20, 30, 40).map((segment, i) => ({
    ...segment,
    action: actions[i] ?? "",
  }));
  let names = renameSegment([], { start: 20, end: 30 }, "walk");
  expect(namesOf(segments, names)).toEqual(["walk", "", "walk", "walk"]);
  names = renameSegment(names, { start: 30, end: 40 }, "march");
  expect(namesOf(segments, names)).toEqual(["walk", "", "walk", "march"]);
  names = renameSegment(names, { start: 20, end: 30 }, "stroll");
  expect(namesOf(segments, names)).toEqual(["stroll", "", "stroll", "march"]);
});

it("gives the pieces of a cut segment its name", () => {
  const detected = segmentsEndingAt(300, 500, 800);
  const names = [{ start: 0, end: 300, name: "walk" }];
  const namesAfter = (...ends: number[]) =>
    nameSegments(segmentsEndingAt(...ends), names, undefined, detected).map(({ name }) => name);
  expect(namesAfter(150, 300, 500, 800)).toEqual(["walk", "walk", "", ""]);
  expect(namesAfter(100, 200, 300, 500, 800)).toEqual(["walk", "walk", "walk", "", ""]);
  expect(namesAfter(500, 800)).toEqual(["walk", ""]);
  expect(namesAfter(310, 500, 800)).toEqual(["walk", "", ""]);
  names.push({ start: 100, end: 200, name: "run" });
  expect(namesAfter(100, 200, 300, 500, 800)).toEqual(["walk", "run", "walk", "", ""]);
});

it("names an action by its detected segments, however they are cut", () => {
  const withActions = (segments: Segment[], actions: string) =>
    segments.map((segment, i) => ({ ...segment, action: actions[i] ?? "" }));
  const detected = withActions(segmentsEndingAt(300, 500, 680), "ABA");
  const namesAfter = (names: readonly SegmentName[], actions: string, ...ends: number[]) => {
    const segments = withActions(segmentsEndingAt(...ends), actions);
    return nameSegments(segments, names, undefined, detected).map(({ name }) => name);
  };
  const first = [{ start: 0, end: 300, name: "walk" }];
  expect(namesAfter(first, "AABA", 150, 300, 500, 680)).toEqual(["walk", "walk", "", "walk"]);
  expect(namesAfter(first, "AAABA", 100, 200, 300, 500, 680)).toEqual([
    "walk",
    "walk",
    "walk",
    "",
    "walk",
  ]);
  const last = [{ start: 500, end: 680, name: "walk" }];
  expect(namesAfter(last, "AB", 300, 680)).toEqual(["walk", ""]);
  // The name of a new piece is that of its action, if the action has none yet.
  const piece = [{ start: 0, end: 100, name: "walk" }];
  expect(namesAfter(piece, "AABA", 100, 300, 500, 680)).toEqual(["walk", "walk", "", "walk"]);
});

it("finds the segment that contains a frame", () => {
  const named = nameSegments(segmentsEndingAt(10, 25, 40), []);
  expect([0, 9, 10, 24, 39, 99].map((frame) => segmentIndexAt(named, frame))).toEqual([
    0, 0, 1, 1, 2, 2,
  ]);
  expect(segmentAt(named, 12)?.number).toBe(2);
  expect(segmentAt([], 3)).toBeUndefined();
  expect(cutsOf(named)).toEqual([10, 25]);
});

it("makes file names that are valid on any system", () => {
  const names = renameSegment([], { start: 10, end: 25 }, " a/b: “turn”? ");
  expect(segmentFileNames(nameSegments(segmentsEndingAt(10, 25), names), "walk")).toEqual([
    "walk-01.bvh",
    "walk-02-a-b-turn.bvh",
  ]);
});

it("makes file names of at most 255 bytes, with the number of the segment", () => {
  const names = [{ start: 0, end: 10, name: "歩".repeat(200) }];
  const named = nameSegments(segmentsEndingAt(10, 25), names);
  for (const clip of ["walk", "走".repeat(200), "a".repeat(300)]) {
    const [first = "", second = ""] = segmentFileNames(named, clip);
    expect(new TextEncoder().encode(first).length).toBeLessThanOrEqual(255);
    expect(first).toMatch(/-01-歩+\.bvh$/);
    expect(second).toMatch(/-02\.bvh$/);
  }
});

it("joins the segments of an action and names actions apart", () => {
  const segments = segmentsEndingAt(100, 180, 300, 400, 500).map((segment, i) => ({
    ...segment,
    action: "ABAC"[i] ?? "",
  }));
  expect(actionsOf(nameSegments(segments, []))).toEqual([
    { name: "A", frames: [0, 100, 180, 300] },
    { name: "B", frames: [100, 180] },
    { name: "C", frames: [300, 400] },
    { name: "5", frames: [400, 500] },
  ]);
  const names = [
    { start: 0, end: 100, name: "limp" },
    { start: 100, end: 180, name: "limp" },
  ];
  const named = actionsOf(nameSegments(segments, names)).map(({ name }) => name);
  expect(named).toEqual(["limp", "limp (B)", "C", "5"]);
});

it("names actions by a vocabulary of several clips", () => {
  const segments = segmentsEndingAt(10, 25, 40).map((segment, i) => ({
    ...segment,
    action: "ABC"[i] ?? "",
  }));
  const actions = new Map([
    ["A", "D"],
    ["B", "D"],
    ["C", "A"],
  ]);
  const names = new Map([
    ["D", "walk"],
    ["A", "bow"],
  ]);
  const shown = (own: { start: number; end: number; name: string }[]) =>
    nameSegments(segments, own, { actions, names }).map(({ action, name }) => `${action} ${name}`);
  expect(shown([])).toEqual(["D walk", "D walk", "A bow"]);
  expect(shown([{ start: 0, end: 10, name: "stroll" }])).toEqual(["D stroll", "D stroll", "A bow"]);
});
