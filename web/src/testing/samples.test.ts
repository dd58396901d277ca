/** What the writer writes is read alike by a reader that is none of ours. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import { expect, test } from "vitest";

const samples = join(import.meta.dirname, "../../../samples");
const names = readdirSync(samples).filter((name) => name.endsWith(".bvh"));

test.each(names)("three.js reads %s", (name) => {
  const text = readFileSync(join(samples, name), "utf8");
  const { clip, skeleton } = new BVHLoader().parse(text);
  const joints = text.match(/^\s*(ROOT|JOINT) /gm)?.length ?? 0;
  const ends = text.match(/^\s*End Site/gm)?.length ?? 0;
  expect(skeleton.bones).toHaveLength(joints + ends);
  const frames = Number(/Frames: (\d+)/.exec(text)?.[1]);
  const time = Number(/Frame Time: ([\d.]+)/.exec(text)?.[1]);
  expect(clip.tracks.length).toBeGreaterThanOrEqual(joints);
  for (const { times, values } of clip.tracks) {
    expect(times).toHaveLength(frames);
    expect(values.every(Number.isFinite)).toBe(true);
  }
  expect(clip.duration).toBeCloseTo((frames - 1) * time, 3);
});
