import { expect, it } from "vitest";
import { extentOf, facingOf, gridStep, reachOf, travelOf } from "./travel";

const joints = [{ name: "Hips", kind: "root" as const }];

it("glides along a straight walk without lag, ends included", () => {
  const frames = 60;
  const positions = Float32Array.from({ length: frames * 3 }, (_, i) =>
    i % 3 === 2 ? Math.floor(i / 3) * 0.1 : 1,
  );
  const path = travelOf({ joints, frames, rate: 30, positions }, 0);
  for (const frame of [0, 1, 30, 58, 59]) expect(path[2 * frame + 1]).toBeCloseTo(frame * 0.1, 4);
});

it("has a place even for a clip without frames", () => {
  const path = travelOf({ joints, frames: 0, rate: 30, positions: Float32Array.of(1, 2, 3) }, 0);
  expect([...path]).toEqual([1, 3]);
});

it("measures a pose", () => {
  const two = [...joints, { name: "Head", kind: "joint" as const, parent: 0 }];
  expect(
    extentOf({ joints: two, positions: Float32Array.of(0, 1, 0, 0, 1.7, 0) }, 0).high,
  ).toBeCloseTo(1.7);
});

it("finds the top of a jump over the floor", () => {
  const positions = Float32Array.of(0, 1, 0, 0, 2.2, 0, 0, 1.1, 0);
  expect(reachOf({ joints, frames: 3, positions }, 0.2)).toBeCloseTo(2);
});

it("faces forward: left hand to the left", () => {
  const two = [...joints, { name: "R", kind: "joint" as const, parent: 0 }];
  const roles = { left_thigh: 0, right_thigh: 1 };
  const positions = Float32Array.of(1, 0, 0, -1, 0, 0);
  const facing = facingOf({ joints: two, roles, positions }, 0);
  expect(facing.z).toBeCloseTo(1);
});

it("measures people in metres, giants in tens", () => {
  expect(gridStep(1.6)).toBe(1);
  expect(gridStep(17)).toBe(10);
  expect(gridStep(0.2)).toBeCloseTo(0.1);
});
