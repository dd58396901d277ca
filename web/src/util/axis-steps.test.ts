import { expect, it } from "vitest";
import { niceCeiling, rulerLabel, timeSteps } from "./axis-steps";

it("chooses the finest steps whose labels fit", () => {
  expect(timeSteps(40)).toEqual({ major: 2, minor: 0.5 });
  expect(timeSteps(2000)).toEqual({ major: 0.05, minor: 0.01 });
  expect(timeSteps(0.001).major).toBe(7200);
});

it("formats seconds with the decimals of the step", () => {
  expect(rulerLabel(12, 2)).toBe("12 s");
  expect(rulerLabel(2.5, 0.5)).toBe("2.5 s");
  expect(rulerLabel(65, 5)).toBe("1:05");
  expect(rulerLabel(65.5, 0.5)).toBe("1:05.5");
  expect(rulerLabel(3600, 600)).toBe("1:00:00");
});

it("rounds the top of an axis up", () => {
  expect(niceCeiling(0.17)).toBeCloseTo(0.2);
  expect(niceCeiling(3.2)).toBe(4);
  expect(niceCeiling(0)).toBe(1);
});
