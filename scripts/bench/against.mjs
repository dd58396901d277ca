/** `npm run bench -- --against REF`: compares the working tree with another commit. */

import { existsSync, rmSync } from "node:fs";
import { join } from "node:path";
import { ask, root, run, Stop, step } from "../run.mjs";
import { targetFolder } from "../setup.mjs";
import { filePath } from "./clips.mjs";
import { timed } from "./core.mjs";
import { startNative } from "./native.mjs";
import { serveBenchPage } from "./page.mjs";
import { alternate, timeRow } from "./pairs.mjs";
import { toTable } from "./report.mjs";

/** Number of pairs per operation. */
const PAIRS = 15;
const FRAMES = 10_000;
/** An operation is slower if the whole interval of its ratio is above this. */
const SLOWER = 1.05;
/** Operations that both the native program and the page have. */
const OPERATIONS = [
  ["read"],
  ["positions"],
  ["detect"],
  ["detect-another-r"],
  ...["auto", "lsd", "pca", "ppca"].map((method) => ["segment", method]),
];

/**
 * Writes a table of the times of the working tree as multiples of those of another commit.
 *
 * @throws {Stop} If the commit does not exist or has no such benchmarks, and if an operation has become
 *   slower.
 */
export async function compareWith(reference, launch) {
  const commit = ask("git", ["rev-parse", "--verify", "--quiet", `${reference}^{commit}`]);
  if (!commit) throw new Stop(`There is no commit ${reference}.`);
  step(`Building ${reference} (${commit.slice(0, 10)})`);
  const tree = join(targetFolder(), "bench-against");
  const target = join(targetFolder(), "bench-against-target");
  if (existsSync(tree)) await run("git", ["worktree", "remove", "--force", tree], { quiet: true });
  rmSync(tree, { recursive: true, force: true });
  await run("git", ["worktree", "prune"], { quiet: true });
  await run("git", ["worktree", "add", "--detach", tree, commit], { quiet: true });
  const opened = [];
  try {
    if (!existsSync(join(tree, "crate/evaluate/src/bin/measure.rs"))) {
      throw new Stop(
        `${reference} has no benchmarks that could be compared; choose a later commit.`,
      );
    }
    const script = 'await (await import("./scripts/setup.mjs")).setup()';
    const environment = { CARGO_TARGET_DIR: target };
    await run(process.execPath, ["--input-type=module", "-e", script], {
      cwd: tree,
      env: environment,
    });
    const ours = { native: await startNative({ tree: root }) };
    const other = { native: await startNative({ tree, target }) };
    opened.push(ours.native, other.native);
    for (const [side, folder] of [
      [ours, root],
      [other, tree],
    ]) {
      const server = await serveBenchPage({ tree: folder, launch });
      side.page = await server.open();
      opened.push(side.page, server);
      await side.native.open(filePath(FRAMES));
      await side.page.open(FRAMES);
    }
    step("Measuring both");
    const rows = [];
    for (const where of ["native", "page"]) {
      for (const [operation, argument] of OPERATIONS) {
        const pairs = await alternate(
          PAIRS,
          timed(ours[where], operation, argument),
          timed(other[where], operation, argument),
        );
        const work = [operation, argument, where === "page" ? "(wasm)" : "(native)"];
        rows.push(timeRow(work.filter(Boolean).join(" "), reference, pairs));
      }
    }
    console.log(`\n${toTable(rows)}`);
    const slower = rows.filter(({ ratio }) => ratio.low > SLOWER).map(({ work }) => work);
    if (slower.length > 0) throw new Stop(`Slower than ${reference}: ${slower.join(", ")}.`);
    console.log(`\nNothing is slower than ${reference}.`);
  } finally {
    for (const resource of opened) await resource.close();
    await run("git", ["worktree", "remove", "--force", tree], { quiet: true });
  }
}
