import { describe, expect, it } from "vitest";
import {
  formatBytes,
  formatClock,
  formatCount,
  formatDuration,
  formatNumber,
  formatRate,
  joinWords,
} from "./format";

describe("formatClock", () => {
  it("shows minutes, seconds and milliseconds", () => {
    expect(formatClock(0)).toBe("0:00.000");
    expect(formatClock(12.875)).toBe("0:12.875");
    expect(formatClock(61.5)).toBe("1:01.500");
  });
  it("carries rounding into the next second", () => expect(formatClock(59.9996)).toBe("1:00.000"));
  it("adds hours", () => expect(formatClock(3600 + 125)).toBe("1:02:05.000"));
});

it("formats durations in seconds or minutes", () => {
  expect(formatDuration(0.417)).toBe("0.42 s");
  expect(formatDuration(31)).toBe("31.0 s");
  expect(formatDuration(725)).toBe("12 min 5 s");
});

it("formats negative numbers with a minus sign and zero without sign", () => {
  expect(formatNumber(-12.34, 1)).toBe("−12.3");
  expect(formatNumber(-0.04, 1)).toBe("0.0");
  expect(formatNumber(7, 0)).toBe("7");
});

it("formats rates without trailing zeros", () => {
  expect(formatRate(120.00048)).toBe("120 Hz");
  expect(formatRate(59.94)).toBe("59.94 Hz");
});

it("groups thousands", () => {
  expect(formatCount(744)).toBe("744");
  expect(formatCount(432000)).toBe("432\u202f000");
});

it("formats file sizes", () => {
  expect(formatBytes(512)).toBe("512 B");
  expect(formatBytes(12_400_000)).toBe("12.4 MB");
});

it("joins words", () => {
  expect(joinWords([])).toBe("");
  expect(joinWords(["height"])).toBe("height");
  expect(joinWords(["height", "speed"])).toBe("height and speed");
  expect(joinWords(["heel", "toe", "speed"])).toBe("heel, toe and speed");
});
