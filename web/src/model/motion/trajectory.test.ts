import { expect, it } from "vitest";
import {
  facingDirection,
  gridStep,
  groundBounds,
  maxHeight,
  smoothedPosition,
  verticalExtent,
} from "./trajectory";

const joints = [{ name: "Hips", kind: "root" as const }];

it("smooths a straight path without lag", () => {
  const frames = 60;
  const positions = Float32Array.from({ length: frames * 3 }, (_, i) =>
    i % 3 === 2 ? Math.floor(i / 3) * 0.1 : 1,
  );
  const clip = { joints, frames, rate: 30, positions };
  for (const frame of [0, 1, 30, 58, 59]) {
    expect(smoothedPosition(clip, 0, frame).z).toBeCloseTo(frame * 0.1, 4);
  }
  const { low, high } = groundBounds(clip, 0);
  expect([low.x, high.x, low.z]).toEqual([1, 1, 0]);
  expect(high.z).toBeCloseTo(5.7);
});

it("uses the rest pose of a clip without frames", () => {
  const clip = { joints, frames: 0, rate: 30, positions: Float32Array.of(1, 2, 3) };
  expect(smoothedPosition(clip, 0, 0)).toEqual({ x: 1, z: 3 });
});

it("measures the vertical extent of a pose", () => {
  const twoJoints = [...joints, { name: "Head", kind: "joint" as const, parent: 0 }];
  expect(
    verticalExtent({ joints: twoJoints, positions: Float32Array.of(0, 1, 0, 0, 1.7, 0) }, 0).high,
  ).toBeCloseTo(1.7);
});

it("finds the largest height above the floor", () => {
  const positions = Float32Array.of(0, 1, 0, 0, 2.2, 0, 0, 1.1, 0);
  expect(maxHeight({ joints, frames: 3, positions }, 0.2)).toBeCloseTo(2);
});

it("faces forward with the left hip on the left", () => {
  const twoJoints = [...joints, { name: "R", kind: "joint" as const, parent: 0 }];
  const roles = { left_thigh: 0, right_thigh: 1 };
  const positions = Float32Array.of(1, 0, 0, -1, 0, 0);
  const facing = facingDirection({ joints: twoJoints, roles, positions }, 0);
  expect(facing.z).toBeCloseTo(1);
});

it("chooses powers of ten", () => {
  expect(gridStep(1.6)).toBe(1);
  expect(gridStep(17)).toBe(10);
  expect(gridStep(0.2)).toBeCloseTo(0.1);
});
