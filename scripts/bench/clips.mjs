/** The clips that are measured with: long ones, and a folder of many. */

import { copyFileSync, mkdirSync, readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { root, run, step } from "../run.mjs";
import { CRATES, targetFolder } from "../setup.mjs";

export const folder = join(root, "target/bench");
/** Frames of about ten and a hundred megabytes, and of an hour, at 120 Hz. */
export const TEN_MEGABYTES = 19_500;
export const HUNDRED_MEGABYTES = 195_000;
export const HOUR = 432_000;
export const LENGTHS = [10_000, TEN_MEGABYTES, 50_000, 100_000, HUNDRED_MEGABYTES, HOUR];
/** A folder as a session of recordings leaves it. */
export const FOLDER = { clips: 500, frames: 2_400 };

/** The file of so many frames; its address is the same below the folder. */
export const address = (frames) => `/${frames}/long.bvh`;
export const path = (frames) => join(folder, address(frames));
export const many = join(folder, "many");

/** Writes all of them: what was written before may be by another generator. */
export async function generate() {
  step("Generating clips");
  await run("cargo", ["build", "--locked", "--release", "-p", "plantigrade-synth"], {
    source: CRATES,
  });
  const synth = join(targetFolder(), "release/plantigrade-synth");
  const write = (frames, seed, out) =>
    run(synth, ["--set", "long", "--frames", `${frames}`, "--seed", `${seed}`, "--out", out], {
      quiet: true,
    });
  rmSync(folder, { recursive: true, force: true });
  for (const frames of LENGTHS) await write(frames, 0, join(folder, `${frames}`));
  mkdirSync(many, { recursive: true });
  const draft = join(folder, "draft");
  for (let clip = 0; clip < FOLDER.clips; clip++) {
    await write(FOLDER.frames, clip, draft);
    copyFileSync(join(draft, "long.bvh"), join(many, `${clip}.bvh`));
  }
  rmSync(draft, { recursive: true });
}

/** The files of the folder of many. */
export const files = () => readdirSync(many).map((name) => join(many, name));
