import { describe, expect, it } from "vitest";
import type { Companion } from "../model/sources/source";
import type { Annotation, Detection, Segmentation } from "../model/types";
import { createWalkingClip, createWalkingTrack } from "../testing/walking-clip";
import { isCurves, type LayoutInput, layoutTimeline } from "./layout";

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
  isTouch: false,
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

it("makes bars large enough to touch on a tablet", () => {
  const input = { ...emptyInput, detection: robust, isTouch: true };
  const bars = layoutTimeline(input, 860, 360).lanes.filter((lane) => !isCurves(lane));
  expect(bars).toHaveLength(6);
  for (const { height } of bars) expect(height).toBeGreaterThanOrEqual(24);
});

describe("comparison clips", () => {
  const companions = Array.from({ length: 5 }, () => ({ source: {}, clip }) as Companion);
  const layoutOf = (count: number, width: number, height: number) =>
    layoutTimeline(
      { ...emptyInput, detection: robust, companions: companions.slice(0, count) },
      width,
      height,
    );

  it("take the space of curves and parts, not that of the minimap", () => {
    for (const [width, height] of [
      [1440, 324],
      [1440, 236],
      [554, 157],
      [390, 280],
    ] as const) {
      for (const count of [1, 2, 5])
        expect(layoutOf(count, width, height).height).toBeLessThanOrEqual(height);
    }
    const shown = layoutOf(5, 1440, 236).lanes.filter(({ kind }) => kind === "companion");
    expect(shown).toHaveLength(5);
  });

  it("are listed if they do not fit", () => {
    const { lanes, omitted } = layoutOf(5, 554, 157);
    expect(lanes.filter(({ kind }) => kind === "companion").length).toBeLessThan(5);
    expect(omitted).toContain("companions");
  });
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
    isTouch: false,
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

  it("fit below the references on a phone in landscape", () => {
    const labels = { left: new Int8Array(9), right: new Int8Array(9) };
    const reference = { name: "truth", parts: { contact: labels } };
    const plain = { ...segmentation, motifs: new Uint32Array(0) };
    const compared = { ...input, reference, segmentation: plain, referenceSegments: null };
    const { lanes, height } = layoutTimeline({ ...compared, isTouch: true }, 554, 157);
    const foot = ["contact", "reference"];
    expect(lanes.map(({ kind }) => kind)).toEqual([...foot, ...foot, "segments"]);
    expect(lanes[0]?.height).toBeGreaterThanOrEqual(28);
    expect(height).toBeLessThanOrEqual(157);
  });

  it("are high enough to touch on a phone", () => {
    const lane = layoutTimeline(input, 390, 388).lanes.find(({ kind }) => kind === "segments");
    expect(lane?.height).toBeGreaterThanOrEqual(28);
  });
});
