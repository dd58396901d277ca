/**
 * `npm run fuzz [-- SECONDS [TARGET...]]`: searches for inputs on which a fuzz target fails, 60 seconds per
 * target by default.
 *
 * Failing inputs are in `crate/core/fuzz/artifacts`; once fixed, they belong to `crate/core/fuzz/regressions`,
 * which `npm test` runs.
 */

import { existsSync, mkdirSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { ask, main, root, run, Stop, step } from "./run.mjs";
import { CRATES, targetFolder, toolchain } from "./setup.mjs";

const CARGO_FUZZ = "0.13.2";

const folder = join(root, "crate/core/fuzz");
const known = readdirSync(join(folder, "fuzz_targets")).map((file) => file.replace(".rs", ""));

await main(async () => {
  const [seconds = "60", ...names] = process.argv.slice(2);
  if (!(Number(seconds) > 0))
    throw new Stop(`The time must be a number of seconds, not "${seconds}".`);
  const unknown = names.find((name) => !known.includes(name));
  if (unknown) throw new Stop(`Unknown target "${unknown}". The targets are ${known.join(", ")}.`);
  await toolchain();
  const cargoFuzz = await install();
  for (const name of names.length > 0 ? names : known) {
    step(`Fuzzing ${name} for ${seconds} s`);
    const inputs = ["corpus", "seeds", "regressions"].map((kind) => join(folder, kind, name));
    mkdirSync(inputs[0], { recursive: true });
    // Without a sanitizer, as the core has no unsafe code, and without tracing comparisons, which
    // takes two thirds of the time.
    const build = ["--fuzz-dir", folder, "--sanitizer", "none", "--no-trace-compares"];
    // Inputs have up to 10 kB. The targets limit processor time; this limit of 20 s finds endless waits.
    const limits = [`-max_total_time=${seconds}`, "-timeout=20", "-max_len=10000"];
    await run(
      cargoFuzz,
      [
        "run",
        ...build,
        name,
        ...inputs.filter(existsSync),
        "--",
        ...limits,
        "-print_final_stats=1",
      ],
      { source: CRATES, env: { RUSTUP_TOOLCHAIN: "nightly" } },
    );
  }
});

/** Installs the nightly toolchain and cargo-fuzz, if they are missing, and returns cargo-fuzz. */
async function install() {
  if (ask("rustc", ["+nightly", "--version"]) === undefined) {
    step("Installing the nightly toolchain");
    await run("rustup", ["toolchain", "install", "nightly", "--profile", "minimal"]);
  }
  const tools = join(targetFolder(), "fuzz-tools");
  const program = join(
    tools,
    "bin",
    process.platform === "win32" ? "cargo-fuzz.exe" : "cargo-fuzz",
  );
  if (ask(program, ["--version"]) !== `cargo-fuzz ${CARGO_FUZZ}`) {
    step("Installing cargo-fuzz");
    await run(
      "cargo",
      ["install", "cargo-fuzz", "--locked", "--version", CARGO_FUZZ, "--root", tools],
      {
        source: CRATES,
      },
    );
  }
  return program;
}
