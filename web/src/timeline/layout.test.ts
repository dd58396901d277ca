import { describe, expect, it } from "vitest";
import type { Annotation, Detection, Segmentation } from "../model/types";
import { walker, walkerTrack } from "../testing/walker";
import { type LayoutInput, layoutTimeline } from "./layout";

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
const nothing: LayoutInput = {
  detection: null,
  reference: null,
  segmentation: null,
  referenceSegments: null,
  companions: [],
};
const kinds = (detection: Detection | null, width: number, room: number) =>
  layoutTimeline({ ...nothing, detection }, width, room).lanes.map((lane) => lane.kind);

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
  const other: Annotation = {
    name: "truth",
    parts: { contact: labels, toe: labels, heel: labels },
  };
  const foot = ["contact", "reference", "heel", "reference", "toe", "reference"];
  const bars = (detection: Detection | null, width: number, room: number) =>
    layoutTimeline({ ...nothing, detection, reference: other }, width, room)
      .lanes.map(({ kind }) => kind)
      .filter((kind) => kind !== "height" && kind !== "speed");

  it("stand below ours, part by part", () => {
    expect(bars(robust, 1440, 284)).toEqual([...foot, ...foot]);
  });
  it("are reduced to one part where room is short", () => {
    const short = ["contact", "reference", "heel", "toe"];
    expect(bars(robust, 390, 272)).toEqual([...short, ...short]);
    expect(
      layoutTimeline({ ...nothing, detection: robust, reference: other }, 390, 272).height,
    ).toBeLessThanOrEqual(280);
  });
  it("stay away where we found none: the reason stands there", () => {
    expect(bars(null, 1440, 284)).toEqual([]);
  });
});

it("gives up curves before it overflows", () => {
  expect(kinds(robust, 1440, 236)).not.toContain("speed");
  expect(kinds(robust, 390, 250)).not.toContain("height");
  for (const room of [236, 284, 400]) {
    expect(
      layoutTimeline({ ...nothing, detection: robust }, 1440, room).height,
    ).toBeLessThanOrEqual(room);
  }
});

it("makes bars a finger can touch on a phone", () => {
  for (const lane of layoutTimeline({ ...nothing, detection: robust }, 390, 388).lanes) {
    if (lane.kind === "toe" || lane.kind === "heel") expect(lane.height).toBeGreaterThanOrEqual(28);
  }
});

describe("segments", () => {
  const values = new Float32Array(9);
  const curve = {
    title: "Distance",
    frames: values,
    values,
    threshold: new Float32Array(0),
    extrema: new Uint32Array(0),
  };
  const segmentation: Segmentation = {
    options: { method: "lsd" },
    segments: [{ start: 0, end: 120, kind: "action", label: "" }],
    transitions: new Uint32Array(0),
    motifs: Uint32Array.of(0, 40, 40, 120),
    classes: Uint32Array.of(1, 2),
    curve,
    notices: [],
  };
  const referenceSegments = { name: "truth", segments: segmentation.segments };
  const shown: LayoutInput = {
    detection: robust,
    reference: null,
    segmentation,
    referenceSegments,
    companions: [],
  };
  const below = (what: LayoutInput, width: number, room: number) =>
    layoutTimeline(what, width, room)
      .lanes.slice(6)
      .map(({ kind }) => kind);

  it("stand below the feet, with motifs, someone else's and the method's curve", () => {
    const all = ["height", "speed", "segments", "motifs", "reference-segments", "curve"];
    expect(below(shown, 1440, 400)).toEqual(all);
    const plain = { ...segmentation, motifs: new Uint32Array(0) };
    const alone = { ...shown, segmentation: plain, referenceSegments: null, companions: [] };
    expect(below(alone, 1440, 351)).toEqual(["height", "speed", "segments", "curve"]);
  });

  it("give up curves before they overflow", () => {
    const single = { ...shown, referenceSegments: null, companions: [] };
    for (const [width, room] of [
      [1440, 300],
      [1440, 270],
      [390, 388],
      [375, 280],
    ] as const) {
      const { height, lanes, minimap } = layoutTimeline(single, width, room);
      expect(height).toBeLessThanOrEqual(room);
      for (const [i, lane] of lanes.entries()) {
        const next = lanes[i + 1]?.y ?? minimap.y;
        expect(lane.y + lane.height).toBeLessThanOrEqual(next);
      }
    }
  });

  it("leave the room of the feet to the reason why there are none", () => {
    const { lanes, minimap, height } = layoutTimeline({ ...shown, detection: null }, 1440, 351);
    expect(lanes.map(({ kind }) => kind)).toEqual([
      "segments",
      "motifs",
      "reference-segments",
      "curve",
    ]);
    expect(lanes[0]?.y).toBeGreaterThan(160);
    expect(minimap.y).toBeGreaterThan(lanes.at(-1)?.y ?? 0);
    expect(height).toBeLessThanOrEqual(351);
  });

  it("are high enough for a finger on a phone", () => {
    const lane = layoutTimeline(shown, 390, 388).lanes.find(({ kind }) => kind === "segments");
    expect(lane?.height).toBeGreaterThanOrEqual(28);
  });
});
