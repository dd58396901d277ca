/** Runs other programs, and reports how to proceed when they fail. */

import { spawn, spawnSync } from "node:child_process";
import { constants, setPriority } from "node:os";
import { fileURLToPath } from "node:url";

/** The folder of the project. */
export const root = fileURLToPath(new URL("..", import.meta.url));

/** An expected failure, whose message tells the user what to do. */
export class Stop extends Error {
  /**
   * @param {string} message
   * @param {string} [output] Output of the failed program.
   */
  constructor(message, output = "") {
    super(message);
    this.output = output;
  }
}

/** Matches the output of programs that failed because of the network. */
const NETWORK =
  /ENOTFOUND|ECONNREFUSED|ECONNRESET|ETIMEDOUT|EAI_AGAIN|Could not resolve host|Couldn't resolve host|failed to download|could not download|spurious network error|Temporary failure|network failure/i;

/**
 * Runs a program in the folder of the project, shows its output and returns it.
 * @param {string} program
 * @param {string[]} args
 * @param {{ cwd?: string, env?: Record<string, string>, hint?: string, source?: string, quiet?: boolean, isBackground?: boolean }} [options]
 *   `cwd`: another folder; `hint`: what to do on failure; `source`: name of the server that it downloads from;
 *   `isBackground`: use only the processor time that other programs leave.
 * @returns {Promise<string>}
 */
export function run(program, args, options = {}) {
  const { cwd = root, env = {}, hint, source, quiet = false, isBackground = false } = options;
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: ["ignore", "pipe", "pipe"],
      shell: process.platform === "win32" && program === "npm",
    });
    if (isBackground && child.pid) setPriority(child.pid, constants.priority.PRIORITY_LOW);
    let output = "";
    for (const [stream, target] of [
      [child.stdout, process.stdout],
      [child.stderr, process.stderr],
    ]) {
      stream.on("data", (chunk) => {
        output += chunk;
        if (!quiet) target.write(chunk);
      });
    }
    child.on("error", (error) =>
      reject(new Stop(`${program} could not be started: ${error.message}`)),
    );
    child.on("close", (code) => {
      if (code === 0) return resolve(output);
      if (quiet) process.stderr.write(output);
      const advice =
        source && NETWORK.test(output)
          ? `${source} could not be reached. Check the network and proxy settings, then try again.`
          : (hint ?? "See the messages above.");
      const command = [program, ...args.slice(0, 3)].join(" ");
      reject(new Stop(`${command} failed. ${advice}`, output));
    });
  });
}

/** Returns the output of a program, or undefined if it does not exist or fails. */
export function ask(program, args, input = "") {
  const { status, stdout } = spawnSync(program, args, {
    cwd: root,
    encoding: "utf8",
    input,
    maxBuffer: 2 ** 28,
  });
  return status === 0 ? stdout.trim() : undefined;
}

/** Runs the body of a script; a `Stop` ends it with its message only. */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    console.error(`\n✖ ${error.message}`);
    process.exitCode = 1;
  }
}

/** Announces the next step. */
export function step(title) {
  console.log(`\n▸ ${title}`);
}
