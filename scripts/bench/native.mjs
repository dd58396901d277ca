/** The native program whose operations are measured, and the command line. */

import { spawn } from "node:child_process";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { run, Stop, step } from "../run.mjs";
import { CRATES, targetFolder } from "../setup.mjs";

/**
 * Builds the native programs of a source tree and starts the measured one.
 * @param {{ tree: string, target?: string }} options Source tree and target folder of cargo.
 */
export async function startNative({ tree, target = targetFolder() }) {
  step("Building the native programs");
  const manifest = ["--manifest-path", join(tree, "Cargo.toml"), "--target-dir", target];
  const programs = ["plantigrade-measure", "plantigrade"].flatMap((name) => ["--bin", name]);
  const packages = ["-p", "plantigrade-evaluate", "-p", "plantigrade-cli"];
  await run("cargo", ["build", "--locked", "--release", ...manifest, ...packages, ...programs], {
    source: CRATES,
  });
  const child = spawn(join(target, "release/plantigrade-measure"), {
    stdio: ["pipe", "pipe", "inherit"],
  });
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  const send = async (line) => {
    child.stdin.write(`${line}\n`);
    const { value, done } = await lines.next();
    if (done) throw new Stop(`plantigrade-measure ended at "${line}".`);
    return Number(value);
  };
  return {
    /** Opens a file for the other operations. */
    open: (path) => send(`open ${path}`),
    /** Returns the mean time of an operation, in milliseconds. */
    measure: (operation, argument) => send(argument ? `${operation} ${argument}` : operation),
    /** Path of the command line. */
    commandLine: join(target, "release/plantigrade"),
    close: () => child.stdin.end(),
  };
}
