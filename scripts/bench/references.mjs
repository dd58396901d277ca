/** Benchmarks of Python libraries on the same clustering problem. */

import { existsSync } from "node:fs";
import { join } from "node:path";
import { ask, root, step } from "../run.mjs";

const environment = join(root, "target/python");
const PACKAGES = ["numpy", "scikit-learn"];

/**
 * Returns the times to cluster the toe signals of clips, in milliseconds by library and number of
 * frames. Libraries that cannot be installed are left out.
 */
export function measureReferences(signals) {
  step("Measuring the reference libraries");
  const script = join(root, "tests/bench/reference.py");
  const output = ask(python(), [script], JSON.stringify(signals));
  const results = output ? JSON.parse(output) : {};
  if (!results.sklearn)
    console.log(
      "scikit-learn is not available, so it is not measured. Install it with pip to include it.",
    );
  return results;
}

/** Returns a Python with the libraries: the installed one, or a virtual environment in `target`. */
function python() {
  if (ask("python3", ["-c", "import numpy, sklearn"]) !== undefined) return "python3";
  const program = join(environment, "bin/python");
  if (!existsSync(program)) {
    ask("python3", ["-m", "venv", environment]);
    ask(program, ["-m", "pip", "install", "--quiet", ...PACKAGES]);
  }
  return existsSync(program) ? program : "python3";
}
