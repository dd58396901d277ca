/** What Python's libraries need for the same work. */

import { existsSync } from "node:fs";
import { join } from "node:path";
import { ask, root, step } from "../run.mjs";

const own = join(root, "target/python");
const WANTED = ["numpy", "scikit-learn"];

/** Milliseconds to cluster the toes of clips, by library and frames; what cannot be had is left out. */
export function references(toes) {
  step("Measuring what others need");
  const script = join(root, "tests/bench/reference.py");
  const output = ask(python(), [script], JSON.stringify(toes));
  const times = output ? JSON.parse(output) : {};
  if (!times.sklearn) console.log("scikit-learn cannot be had here: it is left out.");
  return times;
}

/** A Python with the libraries: this machine's, or one of the project's own where they can be installed. */
function python() {
  if (ask("python3", ["-c", "import numpy, sklearn"]) !== undefined) return "python3";
  const program = join(own, "bin/python");
  if (!existsSync(program)) {
    ask("python3", ["-m", "venv", own]);
    ask(program, ["-m", "pip", "install", "--quiet", ...WANTED]);
  }
  return existsSync(program) ? program : "python3";
}
