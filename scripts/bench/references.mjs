/** Rows on Python libraries, and on the Python package. */

import { join } from "node:path";
import {
  buildWheel,
  environment,
  findPython,
  installWheel,
  pip,
  requirements,
} from "../python.mjs";
import { ask, root, run, step } from "../run.mjs";
import { batchFolder } from "./clips.mjs";
import { speedRow } from "./pairs.mjs";

/**
 * Packages that are compared, as arguments of pip. fairmotion requires a version of torch that can no longer
 * be installed, but its reader works without it.
 */
const PACKAGES = [
  ["scikit-learn"],
  ["gaitkit"],
  ["pybvh"],
  ["bvh"],
  ["bvhio"],
  ["--no-deps", "fairmotion"],
];
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
export async function clusteringRows({ signals, clustering }) {
  step("Measuring the reference libraries");
  const script = join(root, "tests/bench/reference.py");
  const interpreter = await python();
  const output = interpreter && ask(interpreter, [script], JSON.stringify(signals));
  const results = output ? JSON.parse(output) : {};
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

/**
 * Returns rows of the Python package next to other software, measured by `python.py`; none if there is no
 * Python.
 * @param {{ native: { commandLine: string } }} where
 */
export async function packageRows({ native }) {
  step("Measuring the Python package");
  const interpreter = await python();
  if (!interpreter) return [];
  const builder = await environment(findPython().python, "test", requirements());
  await installWheel(interpreter, await buildWheel(builder));
  const script = join(root, "scripts/bench/python.py");
  const output = await run(interpreter, [script, native.commandLine, batchFolder], { quiet: true });
  const measured = JSON.parse(output).rows.filter(({ reference }) => reference);
  return measured.map(({ name, unit, ours, reference, ratio }) => {
    const [, work, title] = /^(.*?): (.*)$/.exec(name);
    const isCommandLine = title === "plantigrade detect";
    return {
      work: `Python: ${work}`,
      reference: isCommandLine ? "command line" : title,
      ours,
      referenceValue: reference,
      ratio,
      bound: "at least",
      target: isCommandLine ? 0.9 : undefined,
      text:
        unit === "ms" ? undefined : (value) => `${Math.round(value).toLocaleString("en")} frames/s`,
    };
  });
}

let prepared;

/** Returns a Python with the libraries that can be installed, or undefined if there is no Python. */
function python() {
  prepared ??= installLibraries();
  return prepared;
}

async function installLibraries() {
  const found = findPython();
  if ("message" in found) {
    console.log(`${found.message} Python libraries are not measured.`);
    return undefined;
  }
  const interpreter = await environment(found.python, "bench", ["numpy"]);
  for (const packages of PACKAGES) {
    await pip(interpreter, packages).catch(() => console.log(`Not available: ${packages.at(-1)}`));
  }
  return interpreter;
}
