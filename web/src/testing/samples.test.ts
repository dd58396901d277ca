/** Cross-check of the sample files with an independent BVH reader. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import { expect, test } from "vitest";

const samples = join(import.meta.dirname, "../../../samples");
const names = readdirSync(samples).filter((name) => name.endsWith(".bvh"));

test.each(names)("three.js reads all joints and frames of %s", (name) => {
  const text = readFileSync(join(samples, name), "utf8");
  const { clip, skeleton } = new BVHLoader().parse(text);
  const joints = text.match(/^\s*(ROOT|JOINT) /gm)?.length ?? 0;
  const endSites = text.match(/^\s*End Site/gm)?.length ?? 0;
  expect(skeleton.bones).toHaveLength(joints + endSites);
  const frames = Number(/Frames: (\d+)/.exec(text)?.[1]);
  const frameTime = Number(/Frame Time: ([\d.]+)/.exec(text)?.[1]);
  expect(clip.tracks.length).toBeGreaterThanOrEqual(joints);
  for (const { times, values } of clip.tracks) {
    expect(times).toHaveLength(frames);
    expect(values.every(Number.isFinite)).toBe(true);
  }
  expect(clip.duration).toBeCloseTo((frames - 1) * frameTime, 3);
});
