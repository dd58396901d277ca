/** Rows on the core: reading, detection and segmentation, natively and as WebAssembly. */

import { step } from "../run.mjs";
import { filePath, HOUR, HUNDRED_MEGABYTES, LENGTHS, TEN_MEGABYTES, urlPath } from "./clips.mjs";
import { alternate, medianInterval, speedRow, timeRow } from "./pairs.mjs";

const SHORT = 10_000;
/** Methods of segmentation that are compared with a detection, and their targets. */
const SEGMENTATIONS = { auto: 1, lsd: 1, pca: 1, "pca-tail": undefined, ppca: 1, mvu: undefined };

/** Returns an operation of a native program or a page. */
export const timed = (where, operation, argument) => () => where.measure(operation, argument);

/**
 * Returns rows on reading.
 * @param {{ native: object, server: object }} where
 */
export async function readingRows({ native, server }) {
  step("Measuring reading");
  const page = await server.open();
  try {
    await native.open(filePath(TEN_MEGABYTES));
    await page.open(TEN_MEGABYTES);
    const read = timed(native, "read");
    const size = "10 MB";
    const rows = [
      speedRow(
        `read ${size}, native`,
        "fast-float2 on the numbers alone",
        await alternate(15, read, timed(native, "fast-float")),
        1,
      ),
      speedRow(
        `read ${size}, native`,
        "bvh_anim",
        await alternate(9, read, timed(native, "bvh_anim")),
        6,
      ),
      timeRow(
        `read ${size}, native`,
        "one pass of memory over the file",
        await alternate(9, read, timed(native, "pass")),
      ),
      speedRow(
        `read ${size}, wasm`,
        "native",
        await alternate(15, timed(page, "read"), read),
        0.75,
      ),
      speedRow(
        `read ${size}, wasm`,
        "BVHLoader of three.js",
        await alternate(7, timed(page, "read-file"), timed(page, "bvh-loader")),
        20,
      ),
    ];
    await page.open(HUNDRED_MEGABYTES);
    rows.push(
      speedRow(
        "read 100 MB, wasm",
        "BVHLoader of three.js",
        await alternate(2, timed(page, "read-file"), timed(page, "bvh-loader")),
        40,
      ),
    );
    return rows;
  } finally {
    await page.close();
  }
}

/** Returns rows on detection, and what the Python references need. */
export async function detectionRows({ native, server }) {
  step("Measuring detection");
  const page = await server.open();
  const first = timed(page, "detect");
  /** Reading and placing all joints of the open clip. */
  const reading = async () => (await page.measure("read")) + (await page.measure("positions"));
  const rows = [];
  const [signals, clustering] = [{}, {}];
  try {
    for (const frames of [SHORT, 100_000]) {
      await page.open(frames);
      rows.push(
        timeRow(
          `label ${frames.toLocaleString("en")} frames`,
          "reading the file and placing all joints",
          await alternate(frames > SHORT ? 7 : 15, first, reading),
          1,
        ),
      );
    }
    await native.open(filePath(SHORT));
    await page.open(SHORT);
    rows.push(
      timeRow(
        "label 10,000 frames",
        "native",
        await alternate(15, first, timed(native, "detect")),
        1.3,
      ),
      speedRow(
        "label 10,000 frames",
        "all pairs of frames",
        await alternate(3, first, timed(page, "detect-all-pairs")),
      ),
      timeRow(
        "label 10,000 frames with another r",
        "first labels",
        await alternate(15, timed(page, "detect-another-r"), first),
        0.35,
      ),
      timeRow(
        "label 10,000 frames with another w",
        "first labels",
        await alternate(9, timed(page, "detect-another-w"), first),
      ),
    );
    for (const frames of [1000, 300]) {
      await page.call("truncate", frames);
      rows.push(
        speedRow(
          `label ${frames.toLocaleString("en")} frames`,
          "all pairs at the peak of the processor",
          await alternate(15, first, allPairsAtPeak(page, frames)),
          0.35,
        ),
      );
      signals[frames] = await page.call("toeSignals");
      clustering[frames] = [];
      for (let run = 0; run < 61; run++) {
        clustering[frames].push(await page.measure("cluster-paper"));
      }
    }
    return { rows, signals, clustering };
  } finally {
    await page.close();
  }
}

/**
 * Returns the time that the arithmetic on all pairs would take at the peak of the processor: two
 * clusterings, which evaluate each pair once, and one comparison of all samples with all others. Counted
 * are distances in six dimensions (18 operations), the kernels (2 and 13), and sums (4 or 2).
 */
function allPairsAtPeak(page, frames) {
  const samples = 2 * frames;
  const contact = (samples ** 2 / 2) * (18 + 2 + 4);
  const toe = samples ** 2 * (18 + 2 + 2);
  const heel = (samples ** 2 / 2) * (18 + 13 + 4);
  const multiplyAdds = (contact + toe + heel) / 2;
  return async () =>
    ((await page.measure("peak")) * multiplyAdds) / (await page.call("peakMultiplyAdds"));
}

/** Returns rows on segmentation. */
export async function segmentationRows({ native, server }) {
  step("Measuring segmentation");
  const page = await server.open();
  try {
    await page.open(SHORT);
    await native.open(filePath(SHORT));
    const rows = [];
    for (const [method, target] of Object.entries(SEGMENTATIONS)) {
      const pairs = await alternate(9, timed(page, "segment", method), timed(page, "detect"));
      rows.push(timeRow(`segment 10,000 frames: ${method}`, "labelling the clip", pairs, target));
    }
    const auto = [timed(page, "segment", "auto"), timed(native, "segment", "auto")];
    rows.push(timeRow("segment 10,000 frames: auto", "native", await alternate(9, ...auto)));
    return rows;
  } finally {
    await page.close();
  }
}

/** Returns rows on growth with the length of a clip, and the measurements for charts. */
export async function growthRows({ server }) {
  step("Measuring long clips");
  const growth = [];
  for (const frames of LENGTHS) {
    const page = await server.open();
    try {
      const before = await page.call("memoryBytes");
      const bytes = await page.open(frames);
      const parsed = (await page.call("memoryBytes")) - before;
      await page.measure("detect");
      const detected = (await page.call("memoryBytes")) - before;
      // After the first run, which includes the compilation of the module.
      const median = async (operation) => {
        const times = [];
        for (let run = 0; run < 5; run++) times.push(await page.measure(operation));
        return medianInterval(times).median;
      };
      growth.push({
        frames,
        bytes,
        detect: await median("detect"),
        parse: await median("read-file"),
        positions: await median("positions"),
        memory: { parsed, detected },
      });
    } finally {
      await page.close();
    }
  }
  const page = await server.open();
  try {
    const perFrame = (frames) => async () => {
      await page.open(frames);
      return (await page.measure("detect")) / (frames / 1000);
    };
    const pairs = await alternate(7, perFrame(HOUR), perFrame(SHORT));
    const { bytes, memory } = growth.at(-1);
    const memoryRow = (stage, value, target) => ({
      ...timeRow(
        `wasm memory after ${stage} one hour`,
        "size of the file",
        [{ ours: value, reference: bytes }],
        target,
      ),
      text: megabytes,
    });
    return {
      growth,
      rows: [
        timeRow("label one hour, per 1,000 frames", "10,000 frames", pairs, 1.15),
        memoryRow("reading", memory.parsed),
        memoryRow("labelling", memory.detected, 1.5),
      ],
    };
  } finally {
    await page.close();
  }
}

/** Returns a row on the memory of a page that reads a long file; none where the system does not report it. */
export async function memoryRows({ server }) {
  const growth = async (name) => {
    const page = await server.open();
    try {
      const before = await page.rendererMemory("VmRSS");
      await page.call(name, urlPath(HUNDRED_MEGABYTES));
      return (await page.rendererMemory("VmHWM")) - before;
    } finally {
      await page.close();
    }
  };
  const pairs = [{ ours: await growth("open"), reference: await growth("load") }];
  if (!Number.isFinite(pairs[0].ours)) return [];
  const row = speedRow("memory of the page to read 100 MB", "BVHLoader of three.js", pairs, 8);
  return [{ ...row, text: megabytes }];
}

const megabytes = (value) => `${(value / 1e6).toFixed(0)} MB`;
