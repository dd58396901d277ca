import { expect, it } from "vitest";
import { formatStoredVideo, parseStoredVideo, toMoment, toVideoTime } from "./video";

it("converts between moments of the clip and times of the video", () => {
  const alignment = { offset: -1.5, rate: 0.25 };
  expect(toVideoTime(120, 120, alignment)).toBeCloseTo(0.625);
  for (const moment of [0, 37.25, 900]) {
    expect(toMoment(toVideoTime(moment, 59.94, alignment), 59.94, alignment)).toBeCloseTo(moment);
  }
});

it("stores name, size and alignment, and no reference to the file", () => {
  const video = { name: "walk.mp4", size: 12_345, offset: 0.25, rate: 1 };
  const text = formatStoredVideo({ ...video, url: "blob:x", problem: "y" });
  expect(text).not.toContain("blob:");
  expect(parseStoredVideo(text)).toEqual(video);
});

it("ignores invalid records", () => {
  const valid = { version: 1, name: "walk.mp4", size: 1, offset: 0, rate: 1 };
  expect(parseStoredVideo(JSON.stringify(valid))).toBeDefined();
  for (const invalid of [
    { ...valid, version: 2 },
    { ...valid, name: 3 },
    { ...valid, size: 1.5 },
    { ...valid, offset: 1e9 },
    { ...valid, rate: 0 },
    { ...valid, rate: "1" },
    null,
    [],
  ]) {
    expect(parseStoredVideo(JSON.stringify(invalid))).toBeUndefined();
  }
  expect(parseStoredVideo(null)).toBeUndefined();
  expect(parseStoredVideo("{")).toBeUndefined();
});
