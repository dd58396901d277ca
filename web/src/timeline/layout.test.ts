import { describe, expect, it } from "vitest";
import { walker, walkerTrack } from "../lib/testing/walker";
import type { Detection, Labelling } from "../worker/types";
import { layOut } from "./layout";

const clip = walker("walk.bvh", 2);
const tracks = {
  left: walkerTrack(clip, 0, 0.1, 0.6, 0, 17),
  right: walkerTrack(clip, 0.5, 0.1, 0.6, 0, 22),
};
const robust: Detection = {
  options: { method: "robust", r: 0.001, w: 1 },
  parts: { contact: tracks, toe: tracks, heel: tracks },
  floor: 0,
  notices: [],
};
const kinds = (detection: Detection | null, width: number, room: number) =>
  layOut(detection, null, width, room).lanes.map((lane) => lane.kind);

it("shows per foot what the method knows, then the curves", () => {
  const foot = ["contact", "heel", "toe"];
  expect(kinds(robust, 1440, 284)).toEqual([...foot, ...foot, "height", "speed"]);
  const paper = { ...robust, parts: { toe: tracks } };
  expect(kinds(paper, 1440, 284)).toEqual(["toe", "toe", "height", "speed"]);
  expect(kinds(null, 1440, 284)).toEqual([]);
});

it("copes with any subset of parts", () => {
  expect(kinds({ ...robust, parts: { contact: tracks } }, 1440, 284)).toEqual([
    "contact",
    "contact",
    "height",
    "speed",
  ]);
  expect(kinds({ ...robust, parts: {} }, 1440, 284)).toEqual([]);
});

describe("someone else's labels", () => {
  const labels = { left: new Int8Array(9), right: new Int8Array(9) };
  const other: Labelling = { name: "truth", parts: { contact: labels, toe: labels, heel: labels } };
  const foot = ["contact", "other", "heel", "other", "toe", "other"];
  const bars = (detection: Detection | null, width: number, room: number) =>
    layOut(detection, other, width, room)
      .lanes.map(({ kind }) => kind)
      .filter((kind) => kind !== "height" && kind !== "speed");

  it("stand below ours, part by part", () => {
    expect(bars(robust, 1440, 284)).toEqual([...foot, ...foot]);
  });
  it("are reduced to one part where room is short", () => {
    const short = ["contact", "other", "heel", "toe"];
    expect(bars(robust, 390, 272)).toEqual([...short, ...short]);
    expect(layOut(robust, other, 390, 272).height).toBeLessThanOrEqual(280);
  });
  it("stay away where we found none: the reason stands there", () => {
    expect(bars(null, 1440, 284)).toEqual([]);
  });
});

it("gives up curves before it overflows", () => {
  expect(kinds(robust, 1440, 236)).not.toContain("speed");
  expect(kinds(robust, 390, 280)).not.toContain("height");
  for (const room of [236, 284, 400]) {
    expect(layOut(robust, null, 1440, room).height).toBeLessThanOrEqual(room);
  }
});

it("makes bars a finger can touch on a phone", () => {
  for (const lane of layOut(robust, null, 390, 364).lanes) {
    if (lane.kind === "toe" || lane.kind === "heel") expect(lane.height).toBeGreaterThanOrEqual(28);
  }
});
