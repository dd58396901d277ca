import { describe, expect, test } from "vitest";
import {
  addPlant,
  matchingPlantRef,
  mergeWithNext,
  nextPlantRef,
  type PartTrack,
  type PlantRef,
  removePlant,
  resizePlant,
  splitPlant,
  withoutEditsOf,
} from "./edits";
import { rangesWhere } from "./intervals";
import type { Edit } from "./types";

const lane = (text: string): PartTrack => ({
  side: "left",
  part: "contact",
  intervals: rangesWhere(text.length, (i) => text[i] === "#"),
  frames: text.length,
});

const stay = (start: number, end: number): PlantRef => ({
  side: "left",
  part: "contact",
  start,
  end,
});

/** What edits make of a lane, laid over it one after the other. */
function laid(text: string, edits: readonly Edit[]): string {
  const frames = [...text];
  for (const { start, end, planted } of edits) frames.fill(planted ? "#" : ".", start, end);
  return frames.join("");
}

describe("edges", () => {
  const text = "..####...###..";

  test.each([
    [{ start: 2, end: 8 }, "..######.###.."],
    [{ start: 0, end: 6 }, "######...###.."],
    [{ start: 4, end: 6 }, "....##...###.."],
    [{ start: 2, end: 3 }, "..#......###.."],
  ])("go to %o", (to, expected) => {
    expect(laid(text, resizePlant(lane(text), stay(2, 6), to))).toBe(expected);
  });

  test("a neighbour that is reached or touched is taken in", () => {
    const joined = "..##########..";
    for (const end of [9, 10, 12]) {
      const edits = resizePlant(lane(text), stay(2, 6), { start: 2, end });
      expect(laid(text, edits)).toBe(joined);
    }
  });

  test("stay in the clip, and a frame apart", () => {
    const out = resizePlant(lane(text), stay(9, 12), { start: 9, end: 99 });
    expect(laid(text, out)).toBe("..####...#####");
    const none = resizePlant(lane(text), stay(2, 6), { start: 6, end: 2 });
    expect(laid(text, none)).toBe("......#..###..");
  });

  test("a stay can move as a whole", () => {
    const moved = resizePlant(lane("..##......"), stay(2, 4), { start: 6, end: 8 });
    expect(laid("..##......", moved)).toBe("......##..");
  });
});

test("the frames beside an edited stay are said to be free", () => {
  const edits = resizePlant(lane("..####...."), stay(2, 6), { start: 3, end: 6 });
  expect(laid(".########.", edits)).toBe(".#.###.##.");
});

test("a stay is split at a frame within it", () => {
  const text = "..#####..";
  expect(laid(text, splitPlant(lane(text), stay(2, 7), 4))).toBe("..##.##..");
  for (const frame of [1, 2, 6, 7]) expect(splitPlant(lane(text), stay(2, 7), frame)).toEqual([]);
});

test("a stay is merged with the next one", () => {
  const text = ".##..##.#";
  expect(laid(text, mergeWithNext(lane(text), stay(1, 3)))).toBe(".######.#");
  expect(mergeWithNext(lane(text), stay(8, 9))).toEqual([]);
});

test("a stay is removed", () => {
  expect(laid(".##..##.", removePlant(stay(5, 7)))).toBe(".##.....");
});

describe("a stay is added", () => {
  test.each([
    [".........", 2, 3, "..###...."],
    ["......##.", 2, 9, "..###.##."],
    ["##.......", 2, 2, "##.##...."],
    [".........", 8, 4, "........#"],
    ["##.#.....", 2, 2, "##.#....."],
    ["..####...", 3, 2, "..####..."],
  ])("to %s at %i for %i frames", (text, frame, length, expected) => {
    expect(laid(text, addPlant(lane(text), frame, length))).toBe(expected);
  });
});

test("stays are found again and followed", () => {
  const held = lane(".##..####.#");
  expect(matchingPlantRef(held, { start: 2, end: 8 })).toMatchObject({ start: 5, end: 9 });
  expect(matchingPlantRef(held, { start: 3, end: 5 })).toBeUndefined();
  expect(nextPlantRef(held, { start: 1, end: 3 })).toMatchObject({ start: 5, end: 9 });
  expect(nextPlantRef(held, { start: 10, end: 11 })).toBeUndefined();
});

test("a stay goes back to what was detected without the others", () => {
  const far: Edit = { side: "left", part: "contact", start: 50, end: 60, planted: true };
  const near = resizePlant(lane("..####...."), stay(2, 6), { start: 3, end: 6 });
  expect(withoutEditsOf([far, ...near], stay(3, 6))).toEqual([far]);
});
