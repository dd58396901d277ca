import { describe, expect, it } from "vitest";
import { footLightOfJoints, footOf } from "./feet";
import {
  type FloorItem,
  footprintOf,
  plantWindowAt,
  soleOf,
  visibilityIntervals,
} from "./footprints";
import type { Joint } from "./types";

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
  expect([...footLightOfJoints({ joints, roles })]).toEqual([0, 0, 1, 2, 0]);
});

describe("footprintOf", () => {
  // Two frames, the foot pointing along +x, drifting one centimetre.
  const frame = (x: number) => [0, 1, 0, x, 0.08, 2, x + 0.1, 0, 2, x + 0.2, 0, 2, 0, 1, 0];
  const clip = { joints, frames: 2, positions: Float32Array.from([...frame(1), ...frame(1.01)]) };
  const foot = { ankle: 1, toe: 2, tip: 3 };
  const sole = soleOf(clip, foot);
  const print = footprintOf(clip, foot, sole, { start: 0, end: 2 });

  it("points where the foot points", () => {
    expect(print.dx).toBeCloseTo(1);
    expect(print.dz).toBeCloseTo(0);
  });
  it("lies under the foot, between heel and toes", () => {
    expect(print.z).toBeCloseTo(2);
    expect(print.x).toBeGreaterThan(1.05);
    expect(print.x).toBeLessThan(1.15);
  });
  it("is longer than ankle to tip", () => {
    expect(print.length).toBeGreaterThan(0.2 * 1.3);
    expect(print.length).toBeLessThan(0.2 * 1.5);
  });
  it("begins where the toes end, whatever the heel does", () => {
    const front = print.x + print.dx * (print.length / 2);
    expect(front).toBeCloseTo(1.21 + sole.front);
  });
  it("is as long as the legs ask for where the skeleton has no toes", () => {
    const stump = soleOf({ ...clip, leg: 0.8 }, { ankle: 1, toe: 1, tip: 1 });
    expect(stump.length).toBeCloseTo(0.2);
    expect(stump.front).toBeGreaterThan(0.15);
  });
  it("reads no frame beyond the clip", () => {
    expect(Number.isFinite(footprintOf(clip, foot, sole, { start: 1, end: 9 }).x)).toBe(true);
  });
});

describe("reigns", () => {
  const at = (x: number, start: number, end: number): FloorItem => ({
    x,
    z: 0,
    radius: 1,
    start,
    end,
  });
  const all = [-1e9, 1e9].map(Math.fround);

  it("shows each of two in one place in its own time", () => {
    expect([...visibilityIntervals([at(0, 0, 4), at(1, 10, 12)])]).toEqual([all[0], 7, 7, all[1]]);
  });
  it("leaves alone what lies apart", () => {
    expect([...visibilityIntervals([at(0, 0, 4), at(2, 10, 12)])]).toEqual([...all, ...all]);
  });
  it("shows feet that stand together", () => {
    expect([...visibilityIntervals([at(0, 0, 11), at(1, 10, 12)])]).toEqual([...all, ...all]);
  });
  it("ends a reign with the next of several", () => {
    const [, first, second, third] = visibilityIntervals([at(0, 0, 2), at(0, 4, 6), at(0, 8, 9)]);
    expect([first, second, third]).toEqual([3, 3, 7]);
  });
  it("finds what lies on what wherever it lies", () => {
    const list = Array.from({ length: 300 }, (_, i) => {
      const [x, z] = [3 * Math.sin(i * i), 3 * Math.cos(7 * i * i)];
      return { x, z, radius: 0.1 + (i % 3) / 10, start: i, end: i + 2 };
    });
    const found = visibilityIntervals(list);
    list.forEach((here, i) => {
      const touching = list.filter(
        (it) => Math.hypot(it.x - here.x, it.z - here.z) < it.radius + here.radius,
      );
      const before = touching.filter(({ end }) => end <= here.start).at(-1);
      const after = touching.find(({ start }) => start >= here.end);
      const [from, until] = found.subarray(2 * i, 2 * i + 2);
      expect(from).toBe(before ? (before.end + here.start) / 2 : all[0]);
      expect(until).toBe(after ? (here.end + after.start) / 2 : all[1]);
    });
  });
});

describe("plantsNear", () => {
  const plants = Array.from({ length: 7200 }, (_, i) => ({ start: 60 * i }));

  it("takes all of a short clip, for good", () => {
    const near = plantWindowAt(plants.slice(0, 200), 900);
    expect([near.from, near.to]).toEqual([0, 200]);
    expect([near.since, near.until]).toEqual([-Infinity, Infinity]);
    expect(plantWindowAt([], 0).to).toBe(0);
  });
  it("takes what is near of a long one, for a while", () => {
    const near = plantWindowAt(plants, 216_000);
    expect(near.to - near.from).toBe(600);
    expect(near.since).toBeGreaterThan(60 * near.from);
    expect(near.since).toBeLessThan(216_000);
    expect(near.until).toBeGreaterThan(216_000);
    expect(near.until).toBeLessThan(60 * near.to);
  });
  it("holds for the moment it was asked for, wherever that is", () => {
    for (const frame of [0, 1, 17_999, 18_000, 300_000, 431_999]) {
      const { since, until } = plantWindowAt(plants, frame);
      expect(since).toBeLessThanOrEqual(frame);
      expect(until).toBeGreaterThan(frame);
    }
  });
});
