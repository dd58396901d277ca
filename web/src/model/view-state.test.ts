import { expect, it } from "vitest";
import { formatViewState, parseViewState, shortestTime, type ViewState } from "./view-state";

const methods = { detect: ["robust", "paper", "dual"], segment: ["auto", "lsd"] };
const read = (text: string) => parseViewState(text, methods);

/** Numbers that look random and are the same every time. */
function dice(seed: number) {
  let state = seed;
  return (sides: number) => {
    state = (state * 1664525 + 1013904223) % 2 ** 32;
    return Math.floor((state / 2 ** 32) * sides);
  };
}

it("is short and can be read by a person", () => {
  expect(formatViewState({})).toBe("");
  expect(formatViewState({ t: 1.25, method: "paper", r: 0.002 })).toBe(
    "t=1.25&method=paper&r=0.002",
  );
  expect(formatViewState({ view: "side", eye: [1.23456, 1.4, -3], at: [0, 0.9, 0] })).toBe(
    "view=side&eye=1.235,1.4,-3&at=0,0.9,0",
  );
});

it("reads what it writes", () => {
  for (let seed = 1; seed <= 500; seed++) {
    const roll = dice(seed);
    const maybe = <T>(make: () => T) => (roll(2) ? make() : undefined);
    const point = () => [roll(2e6) / 1000 - 1000, roll(1e4) / 1000, -roll(1e4) / 1000] as const;
    const camera = maybe(() => ({ eye: point(), at: point() }));
    const all = {
      t: maybe(() => roll(1e6) / 1000),
      method: maybe(() => methods.detect[roll(3)]),
      r: maybe(() => (1 + roll(44)) / 1e4),
      w: maybe(() => roll(5)),
      height: maybe(() => (1 + roll(60)) / 200),
      speed: maybe(() => (1 + roll(60)) / 20),
      segment: maybe(() => methods.segment[roll(2)]),
      dims: maybe(() => 1 + roll(10)),
      residual: maybe(() => "ratio"),
      template: maybe(() => ["tpose", "mean", String(roll(5000))][roll(3)]),
      published: maybe(() => "yes"),
      rate: maybe(() => 1 + roll(999_000) / 1000),
      up: maybe(() => ["x", "-x", "y", "-y", "z", "-z"][roll(6)]),
      unit: maybe(() => 10 ** -roll(9)),
      joints: maybe(() => ({ left_toe: roll(50) - 1, right_ankle: roll(50) })),
      lenient: maybe(() => "yes"),
      view: maybe(() => ["front", "side", "top"][roll(3)]),
      follow: maybe(() => "off"),
      ...camera,
    };
    const view = Object.fromEntries(
      Object.entries(all).filter(([, value]) => value !== undefined),
    ) as ViewState;
    expect(read(formatViewState(view))).toEqual({ view, rejected: [] });
  }
});

it("leaves out what it does not understand, and tells", () => {
  const text =
    "t=-1&method=magic&r=abc&w=1.5&eye=1,2&at=0,0,0&up=w&joints=left_toe&colour=red&speed=0.3&t=Infinity&height=";
  expect(read(text)).toEqual({
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

it("takes no word of a link for more than a word", () => {
  for (const text of ["__proto__=1", "constructor=x", "toString=1", "%00=%00", "&&&", "===", "%"]) {
    expect(read(text).view).toEqual({});
  }
  expect(read("joints=__proto__:3").view.joints).not.toHaveProperty("left_toe");
});

it("tells every frame from its neighbours", () => {
  for (const rate of [1, 24, 29.97, 30, 59.94, 100, 119.88, 120, 240, 480, 1000]) {
    for (let frame = 0; frame < 5000; frame += 7) {
      expect(Math.round(shortestTime(frame, rate) * rate)).toBe(frame);
    }
  }
  expect(shortestTime(30, 24)).toBe(1.25);
});
