import { describe, expect, it } from "vitest";
import type { Annotation, Detection, Segmentation } from "../model/types";
import { createWalkingClip, createWalkingTrack } from "../testing/walking-clip";
import { type LayoutInput, layoutTimeline } from "./layout";

const clip = createWalkingClip("walk.bvh", 2);
const tracks = {
  left: createWalkingTrack(clip, 0, 0.1, 0.6, 0, 17),
  right: createWalkingTrack(clip, 0.5, 0.1, 0.6, 0, 22),
};
const robust: Detection = {
  options: { method: "robust", r: 0.001, w: 1 },
  parts: { contact: tracks, toe: tracks, heel: tracks },
  floor: 0,
  ground: { normal: [0, 1, 0], origin: [0, 0, 0], tilt: 0, levels: [0] },
  notices: [],
};
const emptyInput: LayoutInput = {
  detection: null,
  reference: null,
  segmentation: null,
  referenceSegments: null,
  companions: [],
  hidden: [],
};
const kinds = (detection: Detection | null, width: number, height: number) =>
  layoutTimeline({ ...emptyInput, detection }, width, height).lanes.map((lane) => lane.kind);

it("shows the labelled parts of each foot, then the curves", () => {
  const foot = ["contact", "heel", "toe"];
  expect(kinds(robust, 1440, 284)).toEqual([...foot, ...foot, "height", "speed"]);
  const paper = { ...robust, parts: { toe: tracks } };
  expect(kinds(paper, 1440, 284)).toEqual(["toe", "toe", "height", "speed"]);
  expect(kinds(null, 1440, 284)).toEqual([]);
});

it("lists the tracks that do not fit, without those that are hidden", () => {
  const omitted = (height: number, hidden: LayoutInput["hidden"] = []) =>
    layoutTimeline({ ...emptyInput, detection: robust, hidden }, 1440, height).omitted;
  expect(omitted(284)).toEqual([]);
  expect(omitted(220)).toEqual(["speed"]);
  expect(omitted(120)).toEqual(["parts", "height", "speed"]);
  expect(omitted(120, ["parts", "curves"])).toEqual([]);
});

it("accepts any subset of parts", () => {
  expect(kinds({ ...robust, parts: { contact: tracks } }, 1440, 284)).toEqual([
    "contact",
    "contact",
    "height",
    "speed",
  ]);
  expect(kinds({ ...robust, parts: {} }, 1440, 284)).toEqual([]);
});

describe("reference labels", () => {
  const labels = { left: new Int8Array(9), right: new Int8Array(9) };
  const referenceLabels: Annotation = {
    name: "truth",
    parts: { contact: labels, toe: labels, heel: labels },
  };
  const foot = ["contact", "reference", "heel", "reference", "toe", "reference"];
  const bars = (detection: Detection | null, width: number, height: number) =>
    layoutTimeline({ ...emptyInput, detection, reference: referenceLabels }, width, height)
      .lanes.map(({ kind }) => kind)
      .filter((kind) => kind !== "height" && kind !== "speed");

  it("appear below each detected part", () => {
    expect(bars(robust, 1440, 284)).toEqual([...foot, ...foot]);
  });
  it("are reduced to one part if space is short", () => {
    const short = ["contact", "reference", "heel", "toe"];
    expect(bars(robust, 390, 272)).toEqual([...short, ...short]);
    expect(
      layoutTimeline({ ...emptyInput, detection: robust, reference: referenceLabels }, 390, 272)
        .height,
    ).toBeLessThanOrEqual(280);
  });
  it("are hidden if there is no detection", () => {
    expect(bars(null, 1440, 284)).toEqual([]);
  });
});

it("omits curves instead of overflowing", () => {
  expect(kinds(robust, 1440, 236)).not.toContain("speed");
  expect(kinds(robust, 390, 250)).not.toContain("height");
  for (const height of [236, 284, 400]) {
    expect(
      layoutTimeline({ ...emptyInput, detection: robust }, 1440, height).height,
    ).toBeLessThanOrEqual(height);
  }
});

it("makes bars large enough to touch on a phone", () => {
  for (const lane of layoutTimeline({ ...emptyInput, detection: robust }, 390, 388).lanes) {
    if (lane.kind === "contact") expect(lane.height).toBeGreaterThanOrEqual(32);
    if (lane.kind === "toe" || lane.kind === "heel") expect(lane.height).toBeGreaterThanOrEqual(24);
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
  const input: LayoutInput = {
    detection: robust,
    reference: null,
    segmentation,
    referenceSegments,
    companions: [],
    hidden: [],
  };
  const lanesBelowFeet = (input: LayoutInput, width: number, height: number) =>
    layoutTimeline(input, width, height)
      .lanes.slice(6)
      .map(({ kind }) => kind);

  it("appear below the feet, with motifs, the reference and the curve", () => {
    const all = ["height", "speed", "segments", "motifs", "reference-segments", "curve"];
    expect(lanesBelowFeet(input, 1440, 400)).toEqual(all);
    const withoutMotifs = { ...segmentation, motifs: new Uint32Array(0) };
    const onlySegments = {
      ...input,
      segmentation: withoutMotifs,
      referenceSegments: null,
      companions: [],
    };
    expect(lanesBelowFeet(onlySegments, 1440, 351)).toEqual([
      "height",
      "speed",
      "segments",
      "curve",
    ]);
  });

  it("omit curves instead of overflowing", () => {
    const withoutReference = { ...input, referenceSegments: null, companions: [] };
    for (const [width, availableHeight] of [
      [1440, 300],
      [1440, 270],
      [390, 388],
      [375, 280],
    ] as const) {
      const { height, lanes, minimap } = layoutTimeline(withoutReference, width, availableHeight);
      expect(height).toBeLessThanOrEqual(availableHeight);
      for (const [i, lane] of lanes.entries()) {
        const next = lanes[i + 1]?.y ?? minimap.y;
        expect(lane.y + lane.height).toBeLessThanOrEqual(next);
      }
    }
  });

  it("leave space for a message if there is no detection", () => {
    const { lanes, minimap, height } = layoutTimeline({ ...input, detection: null }, 1440, 351);
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

  it("are high enough to touch on a phone", () => {
    const lane = layoutTimeline(input, 390, 388).lanes.find(({ kind }) => kind === "segments");
    expect(lane?.height).toBeGreaterThanOrEqual(28);
  });
});
