/**
 * The Python package: its wheel, its virtual environments and its tests. Run as a script, builds the
 * wheel in `target/wheels`; arguments are passed to maturin.
 */

import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { join } from "node:path";
import { browser } from "./browser.mjs";
import { writeNotebookPage } from "./notebook-page.mjs";
import { ask, main, root, run, Stop, step } from "./run.mjs";
import { CRATES, pathFlags, setup, TESTED_CRATES, targetFolder } from "./setup.mjs";
import { noticesText, sitePackages, uniquePackages, wheelPackages } from "./third-party.mjs";

const INDEX = "The Python package index";
const folder = join(root, "crate/python");
const isWindows = process.platform === "win32";

/** Oldest version of Python that the package supports. */
const OLDEST = [3, 10];
/** Packages of the tests of clusters and estimators, in an environment of their own because they are large. */
const CLUSTER = ["ray[data]==2.60.0", "scikit-learn==1.9.1", "tqdm", "pytest==9.2.0"];
/** Packages of the tests of notebooks, in an environment of their own because they are large. */
const NOTEBOOK = [
  "jupyterlab==4.6.6",
  "anywidget==0.11.0",
  "matplotlib>=3.8",
  "pandas>=2",
  "pytest==9.2.0",
];
const NOTEBOOK_TESTS = ["test_viewer.py", "test_notebooks.py"];
/** Maximum size of the wheel, in bytes. */
const MAX_WHEEL = 3_000_000;

/**
 * Returns the Python interpreter of `PLANTIGRADE_PYTHON` or of the system; otherwise a message that states
 * what to do.
 * @returns {{ python: string } | { message: string }}
 */
export function findPython() {
  const candidates = [process.env.PLANTIGRADE_PYTHON, "python3", "python"].filter(Boolean);
  const oldest = OLDEST.join(".");
  let message = `Python was not found. Install Python ${oldest} or newer, with its module venv.`;
  for (const python of candidates) {
    const version = ask(python, [
      "-c",
      "import sys, venv, ensurepip; print(*sys.version_info[:2])",
    ]);
    if (!version) continue;
    const [major, minor] = version.split(" ").map(Number);
    if (major > OLDEST[0] || (major === OLDEST[0] && minor >= OLDEST[1])) return { python };
    message = `Python ${major}.${minor} is too old. Install Python ${oldest} or newer.`;
  }
  return { message };
}

/**
 * Creates a virtual environment in the target folder with packages, or updates it if they have changed.
 * Returns its interpreter.
 * @param {string} python
 * @param {string} name
 * @param {string[]} packages Arguments of pip.
 */
export async function environment(python, name, packages) {
  const place = join(targetFolder(), "python", name);
  const interpreter = join(place, isWindows ? "Scripts/python.exe" : "bin/python");
  const stamp = join(place, "packages.txt");
  const wanted = [ask(python, ["--version"]), ...packages].join("\n");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === wanted && existsSync(interpreter)) {
    return interpreter;
  }
  step(`Installing Python packages: ${name}`);
  rmSync(place, { recursive: true, force: true });
  await run(python, ["-m", "venv", place], { quiet: true });
  await pip(interpreter, packages);
  writeFileSync(stamp, wanted);
  return interpreter;
}

/** Installs packages. */
export function pip(interpreter, packages) {
  const install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
  return run(interpreter, [...install, ...packages], { quiet: true, source: INDEX });
}

/** Returns the versions of the tools with which the package is built and tested. */
export function requirements() {
  const text = readFileSync(join(folder, "tests/requirements.txt"), "utf8");
  return text.split("\n").filter((line) => line && !line.startsWith("#"));
}

/** Returns the requirement of the tool that builds the wheel. */
const maturin = () => requirements().filter((line) => line.startsWith("maturin"))[0];

/**
 * Builds the wheel with an interpreter that has maturin, and options of it. Requires the wasm module. Returns
 * its path.
 */
export async function buildWheel(interpreter, options = []) {
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) {
    copyFileSync(join(root, name), join(folder, name));
  }
  // The wheel contains the page of notebooks.
  const packages = uniquePackages([...wheelPackages(), ...sitePackages()]);
  const notices = noticesText(packages, "The Python package of Plantigrade");
  writeFileSync(join(folder, "THIRD-PARTY.txt"), notices);
  await writeNotebookPage(join(folder, "python/plantigrade/_page.html.gz"));
  const wheels = join(targetFolder(), "wheels");
  rmSync(wheels, { recursive: true, force: true });
  mkdirSync(wheels, { recursive: true });
  const manifest = join(folder, "Cargo.toml");
  const build = ["-m", "maturin", "build", "--release", "--locked", "--manifest-path", manifest];
  await run(interpreter, [...build, "--out", wheels, "--interpreter", interpreter, ...options], {
    source: CRATES,
    env: { RUSTFLAGS: [process.env.RUSTFLAGS, ...pathFlags()].filter(Boolean).join(" ") },
  });
  const name = readdirSync(wheels).find((file) => file.endsWith(".whl"));
  if (!name) throw new Stop("maturin has built no wheel. See the messages above.");
  return join(wheels, name);
}

/**
 * Creates the virtual environments of the tests, one after the other. Returns their interpreters, or a message
 * that states why the package cannot be tested. An environment without which only some tests are skipped is
 * undefined if it cannot be created.
 */
export async function prepareEnvironments() {
  const found = findPython();
  if ("message" in found) return found;
  const create = (name, packages) => environment(found.python, name, packages);
  const wheels = "--only-binary=:all:";
  const test = await create("test", requirements());
  // Packages that define orders of joints; only their lists of names are read.
  await optional(() => pip(test, ["--no-deps", "smplx==0.1.28", "mediapipe==1.2.3"]));
  return {
    test,
    notebook: await optional(() => create("notebook", [...NOTEBOOK, wheels])),
    cluster: await optional(() => create("cluster", [...CLUSTER, wheels])),
    oldest: await optional(() => create("numpy-1.26", ["numpy==1.26.4", "pytest==9.*", wheels])),
  };
}

/**
 * Builds the wheel, installs it and runs its tests. Returns the output.
 * @param {ReturnType<typeof prepareEnvironments>} environments
 */
export async function pythonTests(environments) {
  const prepared = await environments;
  if ("message" in prepared) {
    console.log(`${prepared.message} The Python package is not tested.`);
    return "1 skipped in 0s\n";
  }
  const { test: interpreter, notebook, cluster, oldest } = prepared;
  const wheel = await buildWheel(interpreter);
  const size = readFileSync(wheel).length;
  if (size > MAX_WHEEL) throw new Stop(`The wheel has ${size} bytes, more than ${MAX_WHEEL}.`);
  await installWheel(interpreter, wheel);
  // Builds the command line, of which this is a test.
  await run("cargo", ["test", "--locked", "--no-run", ...TESTED_CRATES, "--test", "exports"], {
    source: CRATES,
  });
  const program = join(targetFolder(), "debug", isWindows ? "plantigrade.exe" : "plantigrade");
  const env = { PLANTIGRADE_PROGRAM: program, PYTHONDONTWRITEBYTECODE: "1" };
  const tool = (...args) => run(interpreter, ["-m", ...args], { env });
  const config = join(folder, "pyproject.toml");
  await tool("ruff", "check", "--no-cache", folder);
  await tool("ruff", "format", "--check", "--no-cache", folder);
  const cache = ["--cache-dir", join(targetFolder(), "python/mypy")];
  const notebooks = join(root, "docs/notebooks");
  // Functions of a notebook are explained by its text.
  await tool("ruff", "check", "--no-cache", "--config", config, "--extend-ignore=ANN,D", notebooks);
  await tool("ruff", "format", "--check", "--no-cache", "--config", config, notebooks);
  await tool("mypy", "--config-file", config, ...cache, "-p", "plantigrade");
  await tool("mypy", "--strict", ...cache, join(folder, "tests/typing/user.py"));
  const pytest = (python, ...args) =>
    run(python, ["-m", "pytest", "-p", "no:cacheprovider", "-c", config, ...args], { env });
  const inTests = (files) => files.map((file) => join(folder, "tests", file));
  const others = inTests(["test_ray.py", "test_sklearn.py", ...NOTEBOOK_TESTS]).flatMap((path) => [
    "--ignore",
    path,
  ]);
  let output = await pytest(interpreter, join(folder, "tests"), ...others);
  if (notebook) {
    await installWheel(notebook, wheel);
    output += await pytest(notebook, ...inTests(NOTEBOOK_TESTS));
    output += await jupyterLabTests(notebook);
  } else {
    console.log("The viewer and the notebooks are not tested, because JupyterLab is missing.");
    output += `${NOTEBOOK_TESTS.length + 1} skipped in 0s\n`;
  }
  if (cluster) {
    await installWheel(cluster, wheel);
    output += await pytest(
      cluster,
      ...inTests(["test_ray.py", "test_sklearn.py", "test_batch.py"]),
    );
  }
  if (oldest) {
    await installWheel(oldest, wheel);
    const selection = ["-k", "not parity and not documentation"];
    output += await pytest(oldest, join(folder, "tests"), ...others, ...selection);
  }
  return output;
}

/** Tests the viewer in JupyterLab in a browser. Returns the output. */
async function jupyterLabTests(interpreter) {
  const found = await optional(browser);
  if (!found) {
    console.log("The viewer is not tested in JupyterLab, because there is no browser.");
    return "1 skipped in 0s\n";
  }
  const playwright = join(root, "node_modules/@playwright/test/cli.js");
  const config = join(root, "tests/notebook/playwright.config.ts");
  return run(process.execPath, [playwright, "test", "--config", config], {
    env: { CHROMIUM_PATH: found.chromium, PLANTIGRADE_JUPYTER: interpreter },
  });
}

/** Installs a wheel, also if one of the same version is installed. */
export function installWheel(interpreter, wheel) {
  return pip(interpreter, ["--force-reinstall", "--no-deps", wheel]);
}

/** Runs an installation without which some tests are skipped; returns undefined if it fails. */
async function optional(install) {
  try {
    return await install();
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    console.log(`Some tests of the Python package are skipped. ${error.message}`);
    return undefined;
  }
}

if (process.argv[1] === import.meta.filename) {
  await main(async () => {
    const found = findPython();
    if ("message" in found) throw new Stop(found.message);
    await setup();
    const options = process.argv.slice(2);
    const zig = options.includes("--zig") ? ["ziglang"] : [];
    const interpreter = await environment(found.python, "build", [maturin(), ...zig]);
    const wheel = await buildWheel(interpreter, options);
    console.log(`\nThe wheel is ${wheel}.`);
  });
}
