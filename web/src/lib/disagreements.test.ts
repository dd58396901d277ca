import { expect, it } from "vitest";
import type { Disagreement } from "../worker/types";
import { nextAfter } from "./disagreements";

const at = (start: number): Disagreement => ({
  side: "left",
  part: "toe",
  start,
  end: start + 2,
  kind: "missed",
});
const list = [at(5), at(9), at(30)];

it("goes on to the next beginning and starts over at the end", () => {
  expect(nextAfter(list, 0, 1)?.start).toBe(5);
  expect(nextAfter(list, 5, 1)?.start).toBe(9);
  expect(nextAfter(list, 30, 1)?.start).toBe(5);
});

it("goes back, and from the first to the last", () => {
  expect(nextAfter(list, 10, -1)?.start).toBe(9);
  expect(nextAfter(list, 5, -1)?.start).toBe(30);
});

it("goes nowhere where all agrees", () => expect(nextAfter([], 3, 1)).toBeUndefined());
