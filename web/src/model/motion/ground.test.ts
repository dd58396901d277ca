import { expect, it } from "vitest";
import type { Ground } from "../types";
import { groundPlane, groundText, levelAt } from "./ground";

const level: Ground = { normal: [0, 1, 0], origin: [1, 0.52, 2], tilt: 0, levels: [0] };

it("draws level ground at the height of the floor", () => {
  const detection = { ground: level, floor: 0.5 };
  expect(groundPlane(detection)).toEqual({ slopeX: 0, slopeZ: 0, offset: 0 });
  expect(groundPlane(null)).toEqual({ slopeX: 0, slopeZ: 0, offset: 0 });
  expect(levelAt(detection, 9)).toBe(0);
  expect(groundText(level)).toBeUndefined();
});

it("draws tilted ground through its origin", () => {
  const slope = Math.tan(Math.PI / 18);
  const length = Math.hypot(1, slope);
  const ground: Ground = { ...level, normal: [0, 1 / length, -slope / length], tilt: 10 };
  const { slopeX, slopeZ, offset } = groundPlane({ ground, floor: 0.5 });
  expect(slopeZ).toBeCloseTo(slope);
  expect(slopeX * 1 + slopeZ * 2 + offset).toBeCloseTo(0.02);
  expect(groundText({ ...ground, belt: [0, 0, -1.2] })).toBe("tilted by 10.0°, belt 1.20 m/s");
});

it("finds the level of a foot", () => {
  const detection = { ground: { ...level, levels: [-0.17, 0, 0.17] }, floor: 0.52 };
  expect(levelAt(detection, 0.36)).toBeCloseTo(-0.17);
  expect(levelAt(detection, 0.5)).toBeCloseTo(0);
  expect(groundText(detection.ground)).toBe("3 levels");
});
