import { expect, it } from "vitest";
import { positionToR, rToPosition, sensitivity } from "./sensitivity";

it("covers the range and clamps positions", () => {
  expect(positionToR(0)).toBe(sensitivity.min);
  expect(positionToR(1)).toBe(sensitivity.max);
  expect(positionToR(7)).toBe(sensitivity.max);
});

it("inverts the conversion", () => {
  for (const r of [0.0002, 0.0005, 0.001, 0.003, 0.0044]) {
    expect(positionToR(rToPosition(r))).toBe(r);
  }
});

it("maps equal ratios to equal distances", () => {
  expect(rToPosition(0.0008) - rToPosition(0.0004)).toBeCloseTo(
    rToPosition(0.004) - rToPosition(0.002),
  );
});
