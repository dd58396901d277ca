import { describe, expect, it } from "vitest";
import { bytes, clock, count, hertz, span } from "./time";

describe("clock", () => {
  it("shows minutes, seconds and milliseconds", () => {
    expect(clock(0)).toBe("0:00.000");
    expect(clock(12.875)).toBe("0:12.875");
    expect(clock(61.5)).toBe("1:01.500");
  });
  it("carries rounding into the next second", () => expect(clock(59.9996)).toBe("1:00.000"));
  it("adds hours", () => expect(clock(3600 + 125)).toBe("1:02:05.000"));
});

it("names spans in the unit that reads best", () => {
  expect(span(0.417)).toBe("0.42 s");
  expect(span(31)).toBe("31.0 s");
  expect(span(725)).toBe("12 min 5 s");
});

it("drops needless digits of a rate", () => {
  expect(hertz(120.00048)).toBe("120 Hz");
  expect(hertz(59.94)).toBe("59.94 Hz");
});

it("groups thousands", () => {
  expect(count(744)).toBe("744");
  expect(count(432000)).toBe("432\u202f000");
});

it("names sizes", () => {
  expect(bytes(512)).toBe("512 B");
  expect(bytes(12_400_000)).toBe("12.4 MB");
});
