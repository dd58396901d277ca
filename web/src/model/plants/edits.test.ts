import { describe, expect, test } from "vitest";
import type { Edit } from "../types";
import {
  addPlant,
  joinWithNext,
  matchingPlantRef,
  nextPlantRef,
  type PartTrack,
  type PlantRef,
  removePlant,
  resizePlant,
  splitPlant,
  withoutEditsOf,
} from "./edits";
import { rangesWhere } from "./intervals";

const track = (text: string): PartTrack => ({
  side: "left",
  part: "contact",
  intervals: rangesWhere(text.length, (i) => text[i] === "#"),
  frames: text.length,
});

const plant = (start: number, end: number): PlantRef => ({
  side: "left",
  part: "contact",
  start,
  end,
});

/** Applies edits to a track in order; `#` is planted. */
function applied(text: string, edits: readonly Edit[]): string {
  const frames = [...text];
  for (const { start, end, planted } of edits) frames.fill(planted ? "#" : ".", start, end);
  return frames.join("");
}

describe("resizePlant", () => {
  const text = "..####...###..";

  test.each([
    [{ start: 2, end: 8 }, "..######.###.."],
    [{ start: 0, end: 6 }, "######...###.."],
    [{ start: 4, end: 6 }, "....##...###.."],
    [{ start: 2, end: 3 }, "..#......###.."],
  ])("moves the edges to %o", (to, expected) => {
    expect(applied(text, resizePlant(track(text), plant(2, 6), to))).toBe(expected);
  });

  test("merges plants that overlap or touch the new range", () => {
    const merged = "..##########..";
    for (const end of [9, 10, 12]) {
      const edits = resizePlant(track(text), plant(2, 6), { start: 2, end });
      expect(applied(text, edits)).toBe(merged);
    }
  });

  test("limits the range to the clip and to at least one frame", () => {
    const clipped = resizePlant(track(text), plant(9, 12), { start: 9, end: 99 });
    expect(applied(text, clipped)).toBe("..####...#####");
    const shortest = resizePlant(track(text), plant(2, 6), { start: 6, end: 2 });
    expect(applied(text, shortest)).toBe("......#..###..");
  });

  test("moves a plant without changing its length", () => {
    const moved = resizePlant(track("..##......"), plant(2, 4), { start: 6, end: 8 });
    expect(applied("..##......", moved)).toBe("......##..");
  });
});

test("marks the frames next to an edited plant as not planted", () => {
  const edits = resizePlant(track("..####...."), plant(2, 6), { start: 3, end: 6 });
  expect(applied(".########.", edits)).toBe(".#.###.##.");
});

test("splits a plant at a frame inside it", () => {
  const text = "..#####..";
  expect(applied(text, splitPlant(plant(2, 7), 4))).toBe("..##.##..");
  for (const frame of [1, 2, 6, 7]) expect(splitPlant(plant(2, 7), frame)).toEqual([]);
});

test("joins a plant with the next one", () => {
  const text = ".##..##.#";
  expect(applied(text, joinWithNext([], track(text), plant(1, 3)) ?? [])).toBe(".######.#");
  expect(joinWithNext([], track(text), plant(8, 9))).toBeUndefined();
});

test("joining undoes a split without a trace", () => {
  const other: Edit = { side: "right", part: "contact", start: 4, end: 5, planted: false };
  const edits = [other, ...splitPlant(plant(2, 7), 4)];
  expect(joinWithNext(edits, track("..##.##.."), plant(2, 4))).toEqual([other]);
});

test("removes a plant", () => {
  expect(applied(".##..##.", removePlant(plant(5, 7)))).toBe(".##.....");
});

describe("addPlant", () => {
  test.each([
    [".........", 2, 3, "..###...."],
    ["......##.", 2, 9, "..###.##."],
    ["##.......", 2, 2, "##.##...."],
    [".........", 8, 4, "........#"],
    ["##.#.....", 2, 2, "##.#....."],
    ["..####...", 3, 2, "..####..."],
  ])("adds to %s at %i for %i frames", (text, frame, length, expected) => {
    expect(applied(text, addPlant(track(text), frame, length))).toBe(expected);
  });
});

test("finds the matching and the next plant", () => {
  const labels = track(".##..####.#");
  expect(matchingPlantRef(labels, { start: 2, end: 8 })).toMatchObject({ start: 5, end: 9 });
  expect(matchingPlantRef(labels, { start: 3, end: 5 })).toBeUndefined();
  expect(nextPlantRef(labels, { start: 1, end: 3 })).toMatchObject({ start: 5, end: 9 });
  expect(nextPlantRef(labels, { start: 10, end: 11 })).toBeUndefined();
});

test("removes only the edits of one plant", () => {
  const unrelated: Edit = { side: "left", part: "contact", start: 50, end: 60, planted: true };
  const resized = resizePlant(track("..####...."), plant(2, 6), { start: 3, end: 6 });
  expect(withoutEditsOf([unrelated, ...resized], plant(3, 6))).toEqual([unrelated]);
});
