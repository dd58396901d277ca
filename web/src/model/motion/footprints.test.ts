import { describe, expect, it } from "vitest";
import type { Joint } from "../types";
import { footLightOfJoints, footOf } from "./feet";
import {
  type FloorItem,
  footprintOf,
  plantWindowAt,
  soleOf,
  visibilityIntervals,
} from "./footprints";

const joints: Joint[] = [
  { name: "Hips", kind: "root" },
  { name: "LeftFoot", kind: "joint", parent: 0 },
  { name: "LeftToeBase", kind: "joint", parent: 1 },
  { name: "", kind: "end-site", parent: 2 },
  { name: "Tail", kind: "joint", parent: 0 },
];
const roles = { left_ankle: 1, left_toe: 2 };

describe("footOf", () => {
  it("uses the end site as the tip if no role names one", () => {
    expect(footOf({ joints, roles }, "left")).toEqual({ ankle: 1, toe: 2, tip: 3 });
  });
  it("returns undefined without an ankle", () => {
    expect(footOf({ joints, roles }, "right")).toBeUndefined();
  });
});

it("highlights the bones of heel and toe", () => {
  expect([...footLightOfJoints({ joints, roles })]).toEqual([0, 0, 1, 2, 0]);
});

describe("footprintOf", () => {
  // Two frames, the foot pointing along +x, drifting one centimetre.
  const frame = (x: number) => [0, 1, 0, x, 0.08, 2, x + 0.1, 0, 2, x + 0.2, 0, 2, 0, 1, 0];
  const clip = { joints, frames: 2, positions: Float32Array.from([...frame(1), ...frame(1.01)]) };
  const foot = { ankle: 1, toe: 2, tip: 3 };
  const sole = soleOf(clip, foot);
  const footprint = footprintOf(clip, foot, sole, { start: 0, end: 2 });

  it("has the direction of the foot", () => {
    expect(footprint.dx).toBeCloseTo(1);
    expect(footprint.dz).toBeCloseTo(0);
  });
  it("is centred under the foot", () => {
    expect(footprint.z).toBeCloseTo(2);
    expect(footprint.x).toBeGreaterThan(1.05);
    expect(footprint.x).toBeLessThan(1.15);
  });
  it("is longer than ankle to tip", () => {
    expect(footprint.length).toBeGreaterThan(0.2 * 1.3);
    expect(footprint.length).toBeLessThan(0.2 * 1.5);
  });
  it("ends in front of the toes", () => {
    const front = footprint.x + footprint.dx * (footprint.length / 2);
    expect(front).toBeCloseTo(1.21 + sole.front);
  });
  it("is at least a quarter of the leg if the skeleton has no toes", () => {
    const toeless = soleOf({ ...clip, leg: 0.8 }, { ankle: 1, toe: 1, tip: 1 });
    expect(toeless.length).toBeCloseTo(0.2);
    expect(toeless.front).toBeGreaterThan(0.15);
  });
  it("does not read frames beyond the clip", () => {
    expect(Number.isFinite(footprintOf(clip, foot, sole, { start: 1, end: 9 }).x)).toBe(true);
  });
});

describe("visibilityIntervals", () => {
  const itemAt = (x: number, start: number, end: number): FloorItem => ({
    x,
    z: 0,
    radius: 1,
    start,
    end,
  });
  const unlimited = [-1e9, 1e9].map(Math.fround);

  it("divides the time between two overlapping items", () => {
    expect([...visibilityIntervals([itemAt(0, 0, 4), itemAt(1, 10, 12)])]).toEqual([
      unlimited[0],
      7,
      7,
      unlimited[1],
    ]);
  });
  it("does not limit items that do not overlap in space", () => {
    expect([...visibilityIntervals([itemAt(0, 0, 4), itemAt(2, 10, 12)])]).toEqual([
      ...unlimited,
      ...unlimited,
    ]);
  });
  it("does not limit items that overlap in time", () => {
    expect([...visibilityIntervals([itemAt(0, 0, 11), itemAt(1, 10, 12)])]).toEqual([
      ...unlimited,
      ...unlimited,
    ]);
  });
  it("limits an item by its next neighbour only", () => {
    const [, first, second, third] = visibilityIntervals([
      itemAt(0, 0, 2),
      itemAt(0, 4, 6),
      itemAt(0, 8, 9),
    ]);
    expect([first, second, third]).toEqual([3, 3, 7]);
  });
  it("agrees with a comparison of all pairs", () => {
    const list = Array.from({ length: 300 }, (_, i) => {
      const [x, z] = [3 * Math.sin(i * i), 3 * Math.cos(7 * i * i)];
      return { x, z, radius: 0.1 + (i % 3) / 10, start: i, end: i + 2 };
    });
    const intervals = visibilityIntervals(list);
    list.forEach((item, i) => {
      const touching = list.filter(
        (other) => Math.hypot(other.x - item.x, other.z - item.z) < other.radius + item.radius,
      );
      const before = touching.filter(({ end }) => end <= item.start).at(-1);
      const after = touching.find(({ start }) => start >= item.end);
      const [from, until] = intervals.subarray(2 * i, 2 * i + 2);
      expect(from).toBe(before ? (before.end + item.start) / 2 : unlimited[0]);
      expect(until).toBe(after ? (item.end + after.start) / 2 : unlimited[1]);
    });
  });
});

describe("plantWindowAt", () => {
  const plants = Array.from({ length: 7200 }, (_, i) => ({ start: 60 * i }));

  it("contains all plants of a short clip, for all frames", () => {
    const window = plantWindowAt(plants.slice(0, 200), 900);
    expect([window.from, window.to]).toEqual([0, 200]);
    expect([window.since, window.until]).toEqual([-Infinity, Infinity]);
    expect(plantWindowAt([], 0).to).toBe(0);
  });
  it("contains the nearest plants of a long clip, for a range of frames", () => {
    const window = plantWindowAt(plants, 216_000);
    expect(window.to - window.from).toBe(600);
    expect(window.since).toBeGreaterThan(60 * window.from);
    expect(window.since).toBeLessThan(216_000);
    expect(window.until).toBeGreaterThan(216_000);
    expect(window.until).toBeLessThan(60 * window.to);
  });
  it("can be used for the frame for which it was requested", () => {
    for (const frame of [0, 1, 17_999, 18_000, 300_000, 431_999]) {
      const { since, until } = plantWindowAt(plants, frame);
      expect(since).toBeLessThanOrEqual(frame);
      expect(until).toBeGreaterThan(frame);
    }
  });
});
