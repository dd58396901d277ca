import { describe, expect, it } from "vitest";
import type { Joint } from "../worker/types";
import { footOf, litBones } from "./feet";
import { footprintOf } from "./footprints";

const joints: Joint[] = [
  { name: "Hips", kind: "root" },
  { name: "LeftFoot", kind: "joint", parent: 0 },
  { name: "LeftToeBase", kind: "joint", parent: 1 },
  { name: "", kind: "end-site", parent: 2 },
  { name: "Tail", kind: "joint", parent: 0 },
];
const roles = { left_ankle: 1, left_toe: 2 };

describe("footOf", () => {
  it("takes the end site for the tip where no role names it", () => {
    expect(footOf({ joints, roles }, "left")).toEqual({ ankle: 1, toe: 2, tip: 3 });
  });
  it("knows no foot without an ankle", () => {
    expect(footOf({ joints, roles }, "right")).toBeUndefined();
  });
});

it("tells the heel's bone from the toe's", () => {
  expect([...litBones({ joints, roles })]).toEqual([0, 0, 1, 2, 0]);
});

describe("footprintOf", () => {
  // Two frames, the foot pointing along +x, drifting one centimetre.
  const frame = (x: number) => [0, 1, 0, x, 0.08, 2, x + 0.1, 0, 2, x + 0.2, 0, 2, 0, 1, 0];
  const clip = { joints, frames: 2, positions: Float32Array.from([...frame(1), ...frame(1.01)]) };
  const foot = { ankle: 1, toe: 2, tip: 3 };
  const print = footprintOf(clip, foot, { start: 0, end: 2 });

  it("points where the foot points", () => {
    expect(print.dx).toBeCloseTo(1);
    expect(print.dz).toBeCloseTo(0);
  });
  it("lies at the mean place, between heel and toes", () => {
    expect(print.z).toBeCloseTo(2);
    expect(print.x).toBeGreaterThan(1.05);
    expect(print.x).toBeLessThan(1.15);
  });
  it("is longer than ankle to tip", () => expect(print.length).toBeCloseTo(0.2 * 1.36));
  it("reads no frame beyond the clip", () => {
    expect(Number.isFinite(footprintOf(clip, foot, { start: 1, end: 9 }).x)).toBe(true);
  });
});
