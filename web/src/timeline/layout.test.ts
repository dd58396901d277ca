import { expect, it } from "vitest";
import { walker, walkerTrack } from "../lib/testing/walker";
import type { Detection } from "../worker/types";
import { layOut } from "./layout";

const clip = walker("walk.bvh", 2);
const tracks = {
  left: walkerTrack(clip, 0, 0.1, 0.6, 0, 17),
  right: walkerTrack(clip, 0.5, 0.1, 0.6, 0, 22),
};
const robust: Detection = {
  method: "robust",
  r: 0.001,
  w: 1,
  parts: { contact: tracks, toe: tracks, heel: tracks },
  floor: 0,
  notices: [],
};
const kinds = (detection: Detection | null, width: number, room: number) =>
  layOut(detection, width, room).lanes.map((lane) => lane.kind);

it("shows per foot what the method knows, then the curves", () => {
  const foot = ["contact", "heel", "toe"];
  expect(kinds(robust, 1440, 284)).toEqual([...foot, ...foot, "height", "speed"]);
  const paper = { ...robust, parts: { toe: tracks } };
  expect(kinds(paper, 1440, 284)).toEqual(["toe", "toe", "height", "speed"]);
  expect(kinds(null, 1440, 284)).toEqual([]);
});

it("gives up curves before it overflows", () => {
  expect(kinds(robust, 1440, 236)).not.toContain("speed");
  expect(kinds(robust, 390, 280)).not.toContain("height");
  for (const room of [236, 284, 400]) {
    expect(layOut(robust, 1440, room).height).toBeLessThanOrEqual(room);
  }
});

it("makes bars a finger can touch on a phone", () => {
  for (const lane of layOut(robust, 390, 364).lanes) {
    if (lane.kind === "toe" || lane.kind === "heel") expect(lane.height).toBeGreaterThanOrEqual(28);
  }
});
