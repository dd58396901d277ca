import { expect, it } from "vitest";
import type { Side, Step } from "../types";
import { percentOfCycle, valueAtPercent } from "./gait-cycle";

const step = (side: Side, strike: number, time?: number): Step => ({
  side,
  strike,
  strikeFrame: Math.ceil(strike * 100),
  ...(time !== undefined && {
    stride: {
      time,
      length: 1.4,
      stancePercent: 60,
      swingPercent: 40,
      singleSupportPercent: 40,
      doubleSupportPercent: 20,
    },
  }),
});

it("locates a time in the gait cycle of each foot", () => {
  const steps = [
    step("left", 0.2, 1),
    step("right", 0.7, 1.1),
    step("left", 1.2),
    step("right", 1.8),
  ];
  const at = (side: Side, time: number) => percentOfCycle(steps, side, time);
  expect(at("left", 0.1)).toBeUndefined();
  expect(at("left", 0.2)).toBe(0);
  expect(at("left", 0.95)).toBeCloseTo(75);
  expect(at("right", 0.95)).toBeCloseTo(22.7, 1);
  // The stride does not count.
  expect(at("left", 1.5)).toBeUndefined();
  expect(percentOfCycle([step("left", 0, 1)], "left", 1.2)).toBeUndefined();
});

it("interpolates between percents", () => {
  const mean = Array.from({ length: 101 }, (_, percent) => percent / 2);
  expect(valueAtPercent(mean, 0)).toBe(0);
  expect(valueAtPercent(mean, 33.5)).toBeCloseTo(16.75);
  expect(valueAtPercent(mean, 100)).toBe(50);
  expect(valueAtPercent(undefined, 3)).toBeUndefined();
});
