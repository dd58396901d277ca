/** `npm test`: sets up and runs every check and test there is; `npm test -- NAME...` runs some of them. */

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { browser } from "./browser.mjs";
import { buildSite } from "./build.mjs";
import { buildPackage } from "./package.mjs";
import { main, root, run, Stop, step } from "./run.mjs";
import { bindgen, CRATES, setup, tool } from "./setup.mjs";

const node = (script, ...args) =>
  run(process.execPath, [join(root, "node_modules", script), ...args]);
const cargo = (args, env) => run("cargo", args, { source: CRATES, env });

/** Each check by name: what it is and how it runs; it gives back its output. */
const checks = {
  format: ["Rust format", () => cargo(["fmt", "--all", "--check"])],
  clippy: ["Clippy", clippy],
  doc: [
    "Rust documentation",
    () => cargo(["doc", "--locked", "--no-deps"], { RUSTDOCFLAGS: "-D warnings" }),
  ],
  biome: ["Biome", () => node("@biomejs/biome/bin/biome", "ci", "--error-on-warnings", ".")],
  types: ["TypeScript", () => node("@typescript/native/bin/tsc", "--noEmit", "-p", ".")],
  core: [
    "Core, samples and command line",
    () => cargo(["test", "--locked", "--workspace", ...without("wasm", "bindgen")]),
  ],
  wasm: ["WebAssembly in a browser: page and worker", wasm],
  web: ["Web units", () => node("vitest/vitest.mjs", "run", "--root", "web")],
  package: ["The npm package", packed],
  browser: ["The app in a browser", app],
};

/** Leaves crates out of a workspace's work: those of another target, and tools without tests. */
function without(...crates) {
  return crates.flatMap((crate) => ["--exclude", `plantigrade-${crate}`]);
}

async function clippy() {
  const deny = ["--all-targets", "--", "-D", "warnings"];
  const native = await cargo(["clippy", "--locked", "--workspace", ...without("wasm"), ...deny]);
  const target = ["--target", "wasm32-unknown-unknown"];
  return (
    native + (await cargo(["clippy", "--locked", "-p", "plantigrade-wasm", ...target, ...deny]))
  );
}

/** A test file that is not set to run in a browser runs nothing and passes: so the tests are counted. */
async function wasm() {
  const { chromium, driver } = await browser();
  await bindgen();
  const args = [
    "test",
    "--locked",
    "-p",
    "plantigrade-wasm",
    "--target",
    "wasm32-unknown-unknown",
    "--tests",
  ];
  const output = await cargo(args, {
    CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: tool("wasm-test"),
    // The first start of a browser on a busy machine takes longer than the default of 20 s.
    WASM_BINDGEN_TEST_TIMEOUT: "180",
    CHROMEDRIVER: driver,
    CHROMIUM_PATH: chromium,
  });
  const cases = readFileSync(join(root, "crate/wasm/tests/cases/mod.rs"), "utf8");
  const written = 2 * (cases.match(/#\[wasm_bindgen_test\]/g)?.length ?? 0);
  const ran = passed(output);
  if (ran !== written) throw new Stop(`${written} wasm tests are written, but ${ran} ran.`);
  return output;
}

async function packed() {
  await buildPackage();
  return run(process.execPath, ["--test", join(root, "tests/package/package.test.mjs")]);
}

async function app() {
  const { chromium } = await browser();
  await buildSite();
  return run(process.execPath, [join(root, "node_modules/@playwright/test/cli.js"), "test"], {
    env: { CHROMIUM_PATH: chromium },
  });
}

/** Number of passed tests that an output tells of. */
function passed(output) {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: colours are control characters
  const plain = output.replace(/\u001b\[[0-9;]*m/g, "");
  const cargos = [...plain.matchAll(/test result: ok\. (\d+) passed/g)];
  const vitests = [...plain.matchAll(/^\s*Tests\s+(\d+) passed/gm)];
  const playwrights = [...plain.matchAll(/^\s*(\d+) passed(?: \(|$)/gm)];
  const nodes = [...plain.matchAll(/^\W*pass (\d+)$/gm)];
  return [...cargos, ...vitests, ...playwrights, ...nodes].reduce(
    (sum, match) => sum + Number(match[1]),
    0,
  );
}

await main(async () => {
  const wanted = process.argv.slice(2);
  const unknown = wanted.find((name) => !(name in checks));
  if (unknown)
    throw new Stop(`There is no check ${unknown}: there are ${Object.keys(checks).join(", ")}.`);
  await setup();
  const failures = [];
  let tests = 0;
  for (const [name, [what, check]] of Object.entries(checks)) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    step(what);
    try {
      tests += passed(await check());
    } catch (error) {
      if (!(error instanceof Stop)) throw error;
      failures.push(`${what}: ${error.message}`);
    }
  }
  console.log("");
  if (!existsSync(process.env.PLANTIGRADE_CORPUS ?? join(root, "../shared/corpus"))) {
    console.log(
      "Tests over recorded motion were skipped: there is none here (PLANTIGRADE_CORPUS can name its folder).",
    );
  }
  for (const failure of failures) console.error(`✖ ${failure}`);
  console.log(`${tests} passed, ${failures.length} failed`);
  if (failures.length > 0) throw new Stop("Not everything is as it should be.");
});
