/** Benchmarks of Python libraries on the same clustering problem. */

import { existsSync } from "node:fs";
import { join } from "node:path";
import { ask, root, step } from "../run.mjs";
import { speedRow } from "./pairs.mjs";

const environment = join(root, "target/python");
const PACKAGES = ["numpy", "scikit-learn"];

/** Names of the libraries in the table. */
const TITLES = { sklearn: "scikit-learn", dense: "dense eigensolver of NumPy" };
/** Number of frames, and the target for scikit-learn. */
const TARGETS = { 300: 100, 1000: undefined };

/**
 * Returns rows on clustering the toe signals of short clips with the published method. Libraries that
 * cannot be installed are left out. The libraries run after ours, because their threads would disturb it.
 * @param {{ signals: Record<number, object>, clustering: Record<number, number[]> }} detection Signals by
 *   number of frames, and our times in milliseconds.
 */
export function pythonRows({ signals, clustering }) {
  step("Measuring the reference libraries");
  const script = join(root, "tests/bench/reference.py");
  const output = ask(python(), [script], JSON.stringify(signals));
  const results = output ? JSON.parse(output) : {};
  if (!results.sklearn)
    console.log(
      "scikit-learn is not available, so it is not measured. Install it with pip to include it.",
    );
  return Object.entries(results).flatMap(([library, times]) =>
    Object.entries(times).map(([frames, references]) => {
      const pairs = references.map((reference, run) => {
        const ours = clustering[frames];
        return { ours: ours[run % ours.length], reference };
      });
      const work = `cluster the toe signals of ${Number(frames).toLocaleString("en")} frames (\`paper\`)`;
      return speedRow(
        work,
        TITLES[library],
        pairs,
        library === "sklearn" ? TARGETS[frames] : undefined,
      );
    }),
  );
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
