/** `npm test`: sets up and runs all checks and tests; `npm test -- NAME...` runs some of them. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { browser } from "./browser.mjs";
import { buildSite } from "./build.mjs";
import { countTests } from "./counts.mjs";
import { buildPackage } from "./package.mjs";
import { prepareEnvironments, pythonTests } from "./python.mjs";
import { main, root, run, Stop, step } from "./run.mjs";
import { bindgen, CRATES, setup, TESTED_CRATES, tool, without } from "./setup.mjs";

const WASM = "wasm32-unknown-unknown";

const node = (script, ...args) =>
  run(process.execPath, [join(root, "node_modules", script), ...args]);
const nodeTest = (...files) =>
  run(process.execPath, ["--test", ...files.map((file) => join(root, file))]);
const cargo = (args, env) => run("cargo", args, { source: CRATES, env, isBackground: true });

/** Each check by name: its title, and a function that runs it and returns its output. */
const checks = {
  format: ["Rust format", () => cargo(["fmt", "--all", "--check"])],
  clippy: ["Clippy", clippy],
  doc: [
    "Rust documentation",
    () => cargo(["doc", "--locked", "--no-deps"], { RUSTDOCFLAGS: "-D warnings" }),
  ],
  biome: ["Biome", () => node("@biomejs/biome/bin/biome", "ci", "--error-on-warnings", ".")],
  types: ["TypeScript", () => node("@typescript/native/bin/tsc", "--noEmit", "-p", ".")],
  layers: [
    "Layers of the web app",
    () =>
      node(
        "dependency-cruiser/bin/dependency-cruise.mjs",
        "--config",
        join(root, ".dependency-cruiser.mjs"),
        "web/src",
      ),
  ],
  scripts: [
    "Scripts",
    () =>
      nodeTest(
        "tests/scripts/counts.test.mjs",
        "tests/scripts/pairs.test.mjs",
        "tests/scripts/third-party.test.mjs",
      ),
  ],
  core: [
    "Core, samples and command line",
    () => cargo(["test", "--locked", "--no-fail-fast", ...TESTED_CRATES]),
  ],
  wasm: ["WebAssembly in a page and in a worker", wasm],
  web: ["Web units", () => node("vitest/vitest.mjs", "run", "--root", "web")],
  package: ["The npm package", packageTests],
  size: ["Download size", sizeTests],
  python: ["The Python package", () => pythonTests(environments)],
  browser: ["The app in a browser", browserTests],
};

/**
 * The order of the checks. Phases run one after the other, and the lists of a phase at the same time: the compiler
 * uses the processor time that the browser leaves.
 */
const phases = [
  [["format", "biome", "types", "layers", "scripts", "web"]],
  [
    ["size", "browser"],
    ["clippy", "doc", "core"],
  ],
  [["wasm", "package"], ["python"]],
];

async function clippy() {
  const deny = ["--all-targets", "--", "-D", "warnings"];
  const native = await cargo(["clippy", "--locked", "--workspace", ...without("wasm"), ...deny]);
  const wasmArgs = ["clippy", "--locked", "-p", "plantigrade-wasm", "--target", WASM, ...deny];
  return native + (await cargo(wasmArgs));
}

/**
 * Runs the wasm tests. A test file that is not configured for a browser runs no tests and passes,
 * so that the number of tests is checked.
 */
async function wasm() {
  const { chromium, driver } = await browser();
  await bindgen();
  const crate = ["-p", "plantigrade-wasm", "--target", WASM, "--tests"];
  const output = await cargo(["test", "--locked", "--no-fail-fast", ...crate], {
    CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: tool("wasm-test"),
    // The first start of a browser on a busy machine takes longer than the default of 20 s.
    WASM_BINDGEN_TEST_TIMEOUT: "180",
    CHROMEDRIVER: driver,
    CHROMIUM_PATH: chromium,
  });
  const cases = readFileSync(join(root, "crate/wasm/tests/cases/mod.rs"), "utf8");
  const expected = 2 * (cases.match(/#\[wasm_bindgen_test\]/g)?.length ?? 0);
  const { passed } = countTests(output);
  if (passed !== expected) {
    throw new Stop(`Expected ${expected} wasm tests to pass, but ${passed} did.`, output);
  }
  return output;
}

/** Environments of Python, which are created during other checks. */
let environments;

let siteBuild;

/** Builds the site once for all checks. */
function site() {
  siteBuild ??= buildSite();
  return siteBuild;
}

async function sizeTests() {
  await site();
  return nodeTest("tests/site/size.test.mjs");
}

async function packageTests() {
  await buildPackage();
  return nodeTest("tests/package/package.test.mjs");
}

async function browserTests() {
  const { headlessShell } = await browser();
  await site();
  return run(process.execPath, [join(root, "node_modules/@playwright/test/cli.js"), "test"], {
    env: { CHROMIUM_PATH: headlessShell },
  });
}

/** Runs one check and reports its duration. Returns its counts, and the failure, if any. */
async function runCheck([title, check]) {
  step(title);
  const start = performance.now();
  try {
    return { counts: countTests(await check()) };
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    const counts = countTests(error.output);
    // A check without tests counts as one.
    if (counts.failed === 0) counts.failed = 1;
    return { counts, failure: `${title}: ${error.message}` };
  } finally {
    console.log(`  ${title}: ${((performance.now() - start) / 1000).toFixed(0)} s`);
  }
}

await main(async () => {
  const names = process.argv.slice(2);
  const all = phases.flat(2);
  const unknown = names.find((name) => !all.includes(name));
  if (unknown) throw new Stop(`Unknown check "${unknown}". The checks are ${all.join(", ")}.`);
  // A run of all checks compiles each crate once; without data for the next time, that takes a sixth less.
  if (names.length === 0) process.env.CARGO_INCREMENTAL ??= "0";
  await setup();
  const isSelected = (name) => names.length === 0 || names.includes(name);
  if (isSelected("python")) {
    environments = prepareEnvironments();
    // Reported by the check that awaits it.
    environments.catch(() => {});
  }
  const failures = [];
  const total = { passed: 0, failed: 0, skipped: 0 };
  const runList = async (list) => {
    for (const name of list.filter(isSelected)) {
      const { counts, failure } = await runCheck(checks[name]);
      for (const kind of Object.keys(total)) total[kind] += counts[kind];
      if (failure) failures.push(failure);
    }
  };
  for (const lists of phases) await Promise.all(lists.map(runList));
  console.log("");
  for (const failure of failures) console.error(`✖ ${failure}`);
  if (total.skipped > 0) {
    console.log(
      "Skipped tests need recorded motion (PLANTIGRADE_CORPUS), Firefox, or Python and its packages.",
    );
  }
  console.log(`${total.passed} passed, ${total.failed} failed, ${total.skipped} skipped`);
  if (failures.length > 0) process.exitCode = 1;
});
