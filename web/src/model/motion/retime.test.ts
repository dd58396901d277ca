import { expect, test } from "vitest";
import { retimeFrames } from "./retime";

test("converts frames to the same time at another rate", () => {
  expect([...retimeFrames(Uint32Array.of(24, 48, 60, 61), 24, 120)]).toEqual([120, 240, 300, 305]);
  expect([...retimeFrames(Uint32Array.of(7), 120, 24)]).toEqual([1]);
});
