/** Running other programs, with messages that say what to do when they fail. */

import { spawn, spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";

/** The project's folder. */
export const root = fileURLToPath(new URL("..", import.meta.url));

/** An end that has a reason a person can act on. */
export class Stop extends Error {}

/** The stem of a program's output that says the network failed it. */
const NETWORK =
  /ENOTFOUND|ECONNREFUSED|ECONNRESET|ETIMEDOUT|EAI_AGAIN|Could not resolve host|Couldn't resolve host|failed to download|could not download|spurious network error|Temporary failure|network failure/i;

/**
 * Runs a program in the project's folder and shows its output; gives the output back.
 * @param {string} program
 * @param {string[]} args
 * @param {{ env?: Record<string, string>, hint?: string, source?: string, quiet?: boolean }} [options]
 *   `hint` says what to do when it fails; `source` names what it downloads from.
 * @returns {Promise<string>}
 */
export function run(program, args, options = {}) {
  const { env = {}, hint, source, quiet = false } = options;
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd: root,
      env: { ...process.env, ...env },
      stdio: ["ignore", "pipe", "pipe"],
      shell: process.platform === "win32" && program === "npm",
    });
    let output = "";
    for (const [stream, to] of [
      [child.stdout, process.stdout],
      [child.stderr, process.stderr],
    ]) {
      stream.on("data", (chunk) => {
        output += chunk;
        if (!quiet) to.write(chunk);
      });
    }
    child.on("error", (error) =>
      reject(new Stop(`${program} cannot be started: ${error.message}`)),
    );
    child.on("close", (code) => {
      if (code === 0) return resolve(output);
      if (quiet) process.stderr.write(output);
      const why =
        source && NETWORK.test(output)
          ? `${source} cannot be reached: check the network, a proxy or a mirror, then try again.`
          : (hint ?? "See the messages above.");
      reject(new Stop(`${[program, ...args.slice(0, 3)].join(" ")} failed. ${why}`));
    });
  });
}

/** What a program prints when it is given some input, or undefined if it is not there or fails. */
export function ask(program, args, input = "") {
  const { status, stdout } = spawnSync(program, args, { cwd: root, encoding: "utf8", input });
  return status === 0 ? stdout.trim() : undefined;
}

/** Runs the main work of a script; a stop ends it with its reason alone. */
export async function main(work) {
  try {
    await work();
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    console.error(`\n✖ ${error.message}`);
    process.exitCode = 1;
  }
}

/** Says what comes next. */
export function step(what) {
  console.log(`\n▸ ${what}`);
}
