/** Benchmarks without a browser: the core with Criterion, and the command line on a folder. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { run, step } from "../run.mjs";
import { CRATES, targetFolder } from "../setup.mjs";
import { batchFolder, benchFolder } from "./clips.mjs";

/** Returns times in milliseconds. */
export async function measureNative() {
  step("Measuring without a browser");
  const source = { source: CRATES };
  await run("cargo", ["bench", "--locked", "-p", "plantigrade-evaluate"], source);
  const medianTime = (name) => {
    const file = join(targetFolder(), "criterion", name, "new/estimates.json");
    return JSON.parse(readFileSync(file, "utf8")).median.point_estimate / 1e6;
  };
  await run("cargo", ["build", "--locked", "--release", "-p", "plantigrade-cli"], source);
  const cli = join(targetFolder(), "release/plantigrade");
  const start = performance.now();
  await run(cli, ["detect", batchFolder, "--force", "--out", join(benchFolder, "labels")], {
    quiet: true,
  });
  const folderTime = performance.now() - start;
  const detect = (frames) => medianTime(`detect/${frames}`);
  return {
    parse: medianTime("read/ten-megabytes"),
    detect: { 300: detect(300), 1000: detect(1000), 10000: detect(10_000) },
    segment: medianTime("cut/10000"),
    folder: folderTime,
  };
}
