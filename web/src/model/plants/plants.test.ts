import { describe, expect, it } from "vitest";
import { summarizeCurve } from "../../util/min-max-pyramid";
import type { Detection, Track } from "../types";
import { intervalAt } from "./intervals";
import * as plants from "./plants";

function track(labels: string, confidence = 1): Track {
  const planted = Uint8Array.from(labels, Number);
  const intervals: number[] = [];
  for (const run of labels.matchAll(/1+/g)) intervals.push(run.index, run.index + run[0].length);
  return {
    planted,
    confidence: new Float32Array(planted.length).fill(confidence),
    intervals: Uint32Array.from(intervals),
    instants: new Float64Array(2 * intervals.length).fill(Number.NaN),
    edited: new Uint8Array(intervals.length / 2),
    uncertain: new Uint32Array(),
    height: new Float32Array(planted.length),
    speed: new Float32Array(planted.length),
    summaries: {
      height: summarizeCurve(new Float32Array()),
      speed: summarizeCurve(new Float32Array()),
    },
  };
}

const toe = { left: track("1100111000"), right: track("0011000111") };
const detection: Detection = {
  options: { method: "paper", r: 0.001, w: 1 },
  parts: { toe },
  floor: 0,
  ground: { normal: [0, 1, 0], origin: [0, 0, 0], tilt: 0, levels: [0] },
  notices: [],
};

describe("plantsOf", () => {
  it("numbers both feet together in order of time", () => {
    expect(plants.plantsOf(detection).map((p) => [p.number, p.side, p.start, p.end])).toEqual([
      [1, "left", 0, 2],
      [2, "right", 2, 4],
      [3, "left", 4, 7],
      [4, "right", 7, 10],
    ]);
  });
  it("uses contact rather than toe", () => {
    const contact = { left: track("1111111111"), right: track("0000000000") };
    const both = { ...detection, parts: { toe, contact } };
    expect(plants.plantsOf(both)).toHaveLength(1);
  });
  it("uses any part that is labelled", () => {
    const only = (parts: Detection["parts"]) => plants.plantsOf({ ...detection, parts });
    expect(only({ contact: toe })).toHaveLength(4);
    expect(only({ heel: toe })).toHaveLength(4);
    expect(only({})).toEqual([]);
  });
  it("has the instants that are known", () => {
    const left = track("1100111000");
    left.instants.set([Number.NaN, Number.NaN, 0.07, 0.005, 0.13, 0.01]);
    const [first, , third] = plants.plantsOf({ ...detection, parts: { toe: { ...toe, left } } });
    expect(first?.strike).toBeUndefined();
    expect(first?.off).toEqual({ time: 0.07, uncertainty: 0.005 });
    expect(third?.strike).toEqual({ time: 0.13, uncertainty: 0.01 });
    expect(third?.off).toBeUndefined();
    expect(plants.instantsOf(left, 4)).toEqual({ strike: third?.strike, off: undefined });
    expect(plants.instantsOf(left, 5)).toEqual({ strike: undefined, off: undefined });
  });
  it("averages the confidence of each plant", () => {
    const left = track("1100111000", 0.9);
    left.confidence.fill(0.6, 4, 7);
    const rated = plants.plantsOf({ ...detection, parts: { toe: { ...toe, left } } });
    expect(rated.map(({ confidence }) => Number(confidence.toFixed(3)))).toEqual([0.9, 1, 0.6, 1]);
  });
});

it("finds the interval that contains a frame", () => {
  const { intervals } = toe.left;
  expect(intervalAt(intervals, 0)).toBe(0);
  expect(intervalAt(intervals, 2)).toBe(-1);
  expect(intervalAt(intervals, 6)).toBe(2);
  expect(intervalAt(intervals, 9)).toBe(-1);
});

it("finds the plant that contains a frame, of one side or of either", () => {
  const list = plants.plantsOf(detection);
  expect(plants.plantAt(list, 5)?.number).toBe(3);
  expect(plants.plantAt(list, 5, "right")).toBeUndefined();
});

it("agrees with a linear search", () => {
  const both = { left: track("0110111100010"), right: track("1111011000100") };
  const list = plants.plantsOf({ ...detection, parts: { toe: both } });
  for (let frame = -1; frame < 14; frame++) {
    for (const side of ["left", "right", undefined] as const) {
      const containing = list.filter((p) => p.start <= frame && frame < p.end);
      const last = containing.findLast((p) => !side || p.side === side);
      expect(plants.plantAt(list, frame, side)).toBe(last);
    }
    for (const side of ["left", "right"] as const) {
      const view = { start: frame, end: frame + 4.5 };
      const visible = list.filter(
        (p) => p.side === side && p.start < view.end && p.end > view.start,
      );
      expect(plants.plantsWithin(list, side, view)).toEqual(visible);
    }
  }
});

it("finds the next edge in both directions", () => {
  const edges = plants.plantEdges(plants.plantsOf(detection));
  expect(edges).toEqual([0, 1, 2, 3, 4, 6, 7, 9]);
  expect(plants.nextEdge(edges, 4, 1)).toBe(6);
  expect(plants.nextEdge(edges, 3.5, -1)).toBe(3);
  expect(plants.nextEdge(edges, 9, 1)).toBeUndefined();
});

it("returns the fraction of planted frames", () =>
  expect(plants.plantedFraction(toe.left)).toBe(0.5));

it("lists uncertain ranges of planted frames only", () => {
  const uncertain = track("0111100");
  uncertain.confidence.set([0.5, 0.6, 0.9, 0.6, 0.6, 0.5, 0.5]);
  expect([...plants.uncertainRanges(uncertain.intervals, uncertain.confidence)]).toEqual([
    1, 2, 3, 5,
  ]);
});
