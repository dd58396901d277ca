/** The clips of the benchmarks: long clips, and a folder of many short ones. */

import { copyFileSync, mkdirSync, readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { root, run, step } from "../run.mjs";
import { CRATES, targetFolder } from "../setup.mjs";

export const benchFolder = join(root, "target/bench");
/** Lengths in frames at 120 Hz: files of about 10 MB and 100 MB, and one hour. */
export const TEN_MEGABYTES = 19_500;
export const HUNDRED_MEGABYTES = 195_000;
export const HOUR = 432_000;
export const LENGTHS = [10_000, TEN_MEGABYTES, 50_000, 100_000, HUNDRED_MEGABYTES, HOUR];
/** Number and length of the clips in the folder. */
export const FOLDER = { clips: 500, frames: 2_400 };

/** Returns the URL of the clip with this number of frames, relative to the folder. */
export const urlPath = (frames) => `/${frames}/long.bvh`;
/** Returns the path of the clip with this number of frames. */
export const filePath = (frames) => join(benchFolder, urlPath(frames));
/** The folder of short clips. */
export const batchFolder = join(benchFolder, "many");

/** Generates all clips. Existing clips are replaced, since the generator may have changed. */
export async function generateClips() {
  step("Generating clips");
  await run("cargo", ["build", "--locked", "--release", "-p", "plantigrade-synth"], {
    source: CRATES,
  });
  const synth = join(targetFolder(), "release/plantigrade-synth");
  const write = (frames, seed, out) =>
    run(synth, ["--set", "long", "--frames", `${frames}`, "--seed", `${seed}`, "--out", out], {
      quiet: true,
    });
  rmSync(benchFolder, { recursive: true, force: true });
  for (const frames of LENGTHS) await write(frames, 0, join(benchFolder, `${frames}`));
  mkdirSync(batchFolder, { recursive: true });
  const draft = join(benchFolder, "draft");
  for (let clip = 0; clip < FOLDER.clips; clip++) {
    await write(FOLDER.frames, clip, draft);
    copyFileSync(join(draft, "long.bvh"), join(batchFolder, `${clip}.bvh`));
  }
  rmSync(draft, { recursive: true });
}

/** Returns the paths of the short clips. */
export const batchFiles = () => readdirSync(batchFolder).map((name) => join(batchFolder, name));
