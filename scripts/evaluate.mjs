/** `npm run evaluate`: writes RESULTS.md and its figures. */

import { existsSync } from "node:fs";
import { join } from "node:path";
import { ask, main, run, Stop, step } from "./run.mjs";
import { CRATES, targetFolder, toolchain } from "./setup.mjs";

/** Python package of gait event detectors that results are compared with. */
const GAITKIT = "gaitkit[onnx]==1.5.0";

await main(async () => {
  await toolchain();
  const python = await gaitkit();
  step("Evaluating the detector");
  await run("cargo", ["run", "--locked", "--release", "-p", "plantigrade-evaluate"], {
    env: python ? { PLANTIGRADE_GAITKIT_PYTHON: python } : {},
    source: CRATES,
  });
});

/**
 * Installs gaitkit in a virtual environment of the target folder and returns its Python interpreter,
 * or undefined if Python or the package is not available.
 */
async function gaitkit() {
  const folder = join(targetFolder(), "gaitkit");
  const programs = process.platform === "win32" ? "Scripts" : "bin";
  const python = join(folder, programs, process.platform === "win32" ? "python.exe" : "python");
  const installed = () =>
    existsSync(python) && ask(python, ["-c", "import gaitkit, onnxruntime"]) !== undefined;
  if (installed()) return python;
  step("Installing gaitkit");
  try {
    const system = process.platform === "win32" ? "python" : "python3";
    await run(system, ["-m", "venv", folder], { quiet: true });
    await run(python, ["-m", "pip", "install", "--quiet", GAITKIT], {
      quiet: true,
      source: "The Python package index",
    });
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    console.log(`gaitkit is not available; its rows are left out. ${error.message}`);
    return undefined;
  }
  return installed() ? python : undefined;
}
