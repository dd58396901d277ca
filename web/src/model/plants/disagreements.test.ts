import { expect, it } from "vitest";
import type { Disagreement } from "../types";
import { nextDisagreement } from "./disagreements";

const disagreementAt = (start: number): Disagreement => ({
  side: "left",
  part: "toe",
  start,
  end: start + 2,
  kind: "missed",
});
const list = [disagreementAt(5), disagreementAt(9), disagreementAt(30)];

it("returns the next disagreement and wraps around at the end", () => {
  expect(nextDisagreement(list, 0, 1)?.start).toBe(5);
  expect(nextDisagreement(list, 5, 1)?.start).toBe(9);
  expect(nextDisagreement(list, 30, 1)?.start).toBe(5);
});

it("returns the previous disagreement and wraps around at the start", () => {
  expect(nextDisagreement(list, 10, -1)?.start).toBe(9);
  expect(nextDisagreement(list, 5, -1)?.start).toBe(30);
});

it("returns undefined if there are no disagreements", () =>
  expect(nextDisagreement([], 3, 1)).toBeUndefined());
