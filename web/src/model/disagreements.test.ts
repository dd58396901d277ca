import { expect, it } from "vitest";
import { nextDisagreement } from "./disagreements";
import type { Disagreement } from "./types";

const at = (start: number): Disagreement => ({
  side: "left",
  part: "toe",
  start,
  end: start + 2,
  kind: "missed",
});
const list = [at(5), at(9), at(30)];

it("goes on to the next beginning and starts over at the end", () => {
  expect(nextDisagreement(list, 0, 1)?.start).toBe(5);
  expect(nextDisagreement(list, 5, 1)?.start).toBe(9);
  expect(nextDisagreement(list, 30, 1)?.start).toBe(5);
});

it("goes back, and from the first to the last", () => {
  expect(nextDisagreement(list, 10, -1)?.start).toBe(9);
  expect(nextDisagreement(list, 5, -1)?.start).toBe(30);
});

it("goes nowhere where all agrees", () => expect(nextDisagreement([], 3, 1)).toBeUndefined());
