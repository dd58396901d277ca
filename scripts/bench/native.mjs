/** The core without a browser: Criterion's measurements, and the command line on a folder. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { run, step } from "../run.mjs";
import { CRATES, targetFolder } from "../setup.mjs";
import { folder, many } from "./clips.mjs";

/** Milliseconds of each, and of the command line for a folder of clips. */
export async function native() {
  step("Measuring without a browser");
  const source = { source: CRATES };
  await run("cargo", ["bench", "--locked", "-p", "plantigrade-evaluate"], source);
  const milliseconds = (name) => {
    const file = join(targetFolder(), "criterion", name, "new/estimates.json");
    return JSON.parse(readFileSync(file, "utf8")).median.point_estimate / 1e6;
  };
  await run("cargo", ["build", "--locked", "--release", "-p", "plantigrade-cli"], source);
  const cli = join(targetFolder(), "release/plantigrade");
  const start = performance.now();
  await run(cli, ["detect", many, "--force", "--out", join(folder, "labels")], { quiet: true });
  const ofFolder = performance.now() - start;
  const detect = (frames) => milliseconds(`detect/${frames}`);
  return {
    read: milliseconds("read/ten-megabytes"),
    detect: { 300: detect(300), 1000: detect(1000), 10000: detect(10_000) },
    cut: milliseconds("cut/10000"),
    folder: ofFolder,
  };
}
