import { expect, it } from "vitest";
import { formatViewState, parseViewState, shortestTime, type ViewState } from "./view-state";

const methods = { detect: ["robust", "paper", "dual"], segment: ["auto", "lsd"] };
const parse = (text: string) => parseViewState(text, methods);

/** Returns a reproducible random number generator. */
function createRandom(seed: number) {
  let state = seed;
  return (limit: number) => {
    state = (state * 1664525 + 1013904223) % 2 ** 32;
    return Math.floor((state / 2 ** 32) * limit);
  };
}

it("formats readably and without default values", () => {
  expect(formatViewState({})).toBe("");
  expect(formatViewState({ t: 1.25, method: "paper", r: 0.002 })).toBe(
    "t=1.25&method=paper&r=0.002",
  );
  expect(formatViewState({ view: "side", eye: [1.23456, 1.4, -3], at: [0, 0.9, 0] })).toBe(
    "view=side&eye=1.235,1.4,-3&at=0,0.9,0",
  );
});

it("parses what it formats", () => {
  for (let seed = 1; seed <= 500; seed++) {
    const random = createRandom(seed);
    const optional = <T>(make: () => T) => (random(2) ? make() : undefined);
    const point = () =>
      [random(2e6) / 1000 - 1000, random(1e4) / 1000, -random(1e4) / 1000] as const;
    const camera = optional(() => ({ eye: point(), at: point() }));
    const all = {
      t: optional(() => random(1e6) / 1000),
      method: optional(() => methods.detect[random(3)]),
      r: optional(() => (1 + random(44)) / 1e4),
      w: optional(() => random(5)),
      height: optional(() => (1 + random(60)) / 200),
      speed: optional(() => (1 + random(60)) / 20),
      segment: optional(() => methods.segment[random(2)]),
      dims: optional(() => 1 + random(10)),
      residual: optional(() => "ratio"),
      template: optional(() => ["tpose", "mean", String(random(5000))][random(3)]),
      published: optional(() => "yes"),
      rate: optional(() => 1 + random(999_000) / 1000),
      up: optional(() => ["x", "-x", "y", "-y", "z", "-z"][random(6)]),
      unit: optional(() => 10 ** -random(9)),
      joints: optional(() => ({ left_toe: random(50) - 1, right_ankle: random(50) })),
      lenient: optional(() => "yes"),
      view: optional(() => ["front", "side", "top"][random(3)]),
      follow: optional(() => "off"),
      ...camera,
    };
    const view = Object.fromEntries(
      Object.entries(all).filter(([, value]) => value !== undefined),
    ) as ViewState;
    expect(parse(formatViewState(view))).toEqual({ view, rejected: [] });
  }
});

it("rejects unknown keys and invalid values", () => {
  const text =
    "t=-1&method=magic&r=abc&w=1.5&eye=1,2&at=0,0,0&up=w&joints=left_toe&colour=red&speed=0.3&t=Infinity&height=";
  expect(parse(text)).toEqual({
    view: { speed: 0.3 },
    rejected: [
      "t=-1",
      "method=magic",
      "r=abc",
      "w=1.5",
      "eye=1,2",
      "up=w",
      "joints=left_toe",
      "colour=red",
      "t=Infinity",
      "height=",
      "at without eye",
    ],
  });
});

it("ignores keys of object prototypes", () => {
  for (const text of ["__proto__=1", "constructor=x", "toString=1", "%00=%00", "&&&", "===", "%"]) {
    expect(parse(text).view).toEqual({});
  }
  expect(parse("joints=__proto__:3").view.joints).not.toHaveProperty("left_toe");
});

it("identifies every frame by its time", () => {
  for (const rate of [1, 24, 29.97, 30, 59.94, 100, 119.88, 120, 240, 480, 1000]) {
    for (let frame = 0; frame < 5000; frame += 7) {
      expect(Math.round(shortestTime(frame, rate) * rate)).toBe(frame);
    }
  }
  expect(shortestTime(30, 24)).toBe(1.25);
});
