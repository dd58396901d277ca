/** Writes BENCHMARKS.md: the measurements with their targets, and charts of growth. */

import { writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { root } from "../run.mjs";
import { FOLDER, HOUR } from "./clips.mjs";
import { METHODS } from "./core.mjs";
import { lineChart } from "./line-chart.mjs";

const chartFolder = "docs/results";

const formatTime = (value) =>
  value >= 1000 ? `${(value / 1000).toFixed(2)} s` : `${value.toPrecision(3)} ms`;
const formatRatio = (value) => `${value.toPrecision(3)} ×`;
const formatMegabytes = (bytes) => `${(bytes / 1e6).toFixed(bytes < 1e8 ? 1 : 0)} MB`;
const formatRate = (bytes, time) => `${(bytes / 1e3 / time).toFixed(0)} MB/s`;
const formatKilobytes = (bytes) => `${(bytes / 1000).toFixed(0)} KB`;
const formatCount = (value) => Number(value).toLocaleString("en");

/** Writes the charts of time and memory by the length of a clip. */
export function writeCharts(growth) {
  const x = { title: "frames", text: formatCount };
  const series = (label, value) => ({
    label,
    points: growth.map((row) => [row.frames, value(row)]),
  });
  const write = (name, chart) => writeFileSync(join(root, chartFolder, name), lineChart(chart));
  write("growth-time.svg", {
    title: "Time by length of the clip",
    x,
    y: { title: "time", text: (value) => (value < 1000 ? `${value} ms` : `${value / 1000} s`) },
    series: [
      series("detection of all parts", (row) => row.detect),
      series("parsing", (row) => row.parse),
      series("joint positions", (row) => row.positions),
    ],
  });
  write("growth-memory.svg", {
    title: "WebAssembly memory by length of the clip",
    x,
    y: { title: "memory", text: (value) => `${value} MB` },
    series: [
      series("after detection", (row) => row.memory.detected / 1e6),
      series("after parsing and positions", (row) => row.memory.parsed / 1e6),
      series("file", (row) => row.bytes / 1e6),
    ],
  });
}

/** Returns a row of the table. Without a measurement or a target, `isMet` is undefined. */
const tableRow = (task, ours, reference, target, isMet) => {
  const result = isMet ? "met" : "**missed**";
  return `| ${task} | ${ours} | ${reference} | ${target} | ${isMet === undefined ? "-" : result} |`;
};

function parsingRows({ core: { parsing, memory, growth }, native }) {
  const longest = growth.at(-1);
  const parsingRow = ({ bytes, ours, loader }, minRatio) => {
    const ratio = loader / ours;
    const isMet = bytes / 1e3 / ours >= 250 && ratio >= minRatio;
    return tableRow(
      `parse ${formatMegabytes(bytes)}`,
      formatRate(bytes, ours),
      `BVHLoader ${formatRate(bytes, loader)}: ${formatRatio(ratio)}`,
      `250 MB/s, ${minRatio} ×`,
      isMet,
    );
  };
  const rows = [
    parsingRow(parsing.ten, 40),
    parsingRow(parsing.hundred, 40),
    tableRow(
      `parse ${formatMegabytes(parsing.ten.bytes)}, native build`,
      formatRate(parsing.ten.bytes, native.parse),
      "-",
      "400 MB/s",
      parsing.ten.bytes / 1e3 / native.parse >= 400,
    ),
  ];
  if (memory.ours && memory.loader) {
    const ratio = memory.loader.growth / memory.ours.growth;
    rows.push(
      tableRow(
        `memory of the page to parse ${formatMegabytes(memory.ours.bytes)}`,
        formatMegabytes(memory.ours.growth),
        `BVHLoader ${formatMegabytes(memory.loader.growth)}: ${formatRatio(ratio)}`,
        "8 ×",
        ratio >= 8,
      ),
    );
  }
  for (const [stage, bytes] of [
    ["parsing and positions", longest.memory.parsed],
    ["detection", longest.memory.detected],
  ]) {
    const ratio = bytes / longest.bytes;
    rows.push(
      tableRow(
        `wasm memory after ${stage}, one hour`,
        formatRatio(ratio),
        "-",
        "2 × the file",
        ratio <= 2,
      ),
    );
  }
  return rows;
}

function detectionRows({ core, native, references }) {
  const { detect, exact, published, redetect, growth } = core;
  const targets = { 300: 2, 1000: 10, 10000: 100 };
  const rows = Object.entries(targets).flatMap(([frames, target]) => {
    const time = detect[frames];
    const row = tableRow(
      `detect plants in ${formatCount(frames)} frames`,
      formatTime(time),
      `all pairs ${formatTime(exact[frames])}, native ${formatTime(native.detect[frames])}`,
      formatTime(target),
      time < target,
    );
    return published[frames] ? [row, clusteringRow(frames, published[frames], references)] : [row];
  });
  const longest = growth.at(-1);
  return [
    ...rows,
    tableRow(
      `detect plants in ${formatCount(HOUR)} frames`,
      formatTime(longest.detect),
      "-",
      "2 s",
      longest.detect < 2000,
    ),
    tableRow(
      "detect again in 10,000 frames after a change of r",
      formatTime(redetect.r),
      "-",
      "16.7 ms",
      redetect.r < 16.7,
    ),
  ];
}

/** Compares the clustering of the published method with reference libraries. */
function clusteringRow(frames, { total, clustering }, references) {
  const comparisons = [
    ["scikit-learn", references.sklearn?.[frames]],
    ["dense eigensolver", references.dense?.[frames]],
  ]
    .filter(([, times]) => times)
    .map(([title, { median, minimum }]) => {
      const range = `at least ${formatTime(minimum)}: ${formatRatio(minimum / clustering)}`;
      return `${title} ${formatTime(median)}: ${formatRatio(median / clustering)} (${range})`;
    });
  const target = { 300: 100 }[frames];
  const sklearn = target && references.sklearn?.[frames];
  return tableRow(
    `cluster the toe signals of ${formatCount(frames)} frames (\`paper\`)`,
    `${formatTime(clustering)}, with positions ${formatTime(total)}`,
    comparisons.join(", ") || "-",
    target ? formatRatio(target) : "-",
    sklearn && sklearn.median / clustering >= target,
  );
}

function segmentationRows({ core: { segment }, native }) {
  return METHODS.map((method) => {
    const target = method === "mvu" ? 4000 : 300;
    const reference = method === "auto" ? `native ${formatTime(native.segment)}` : "-";
    const time = segment[method];
    return tableRow(
      `segment 10,000 frames: ${method}`,
      formatTime(time),
      reference,
      formatTime(target),
      time < target,
    );
  });
}

function appRows({ app, native, sizes, core: { parsing, growth } }) {
  const { drop, hour, six, folder } = app;
  const { clips, frames } = FOLDER;
  const fileSize = formatMegabytes(parsing.ten.bytes);
  const hourSize = formatMegabytes(growth.at(-1).bytes);
  const isSmooth = ({ script, longest }) => script < 8 && longest < 50;
  return [
    tableRow(
      `drop ${fileSize} → moving skeleton`,
      formatTime(drop.firstPose),
      "-",
      "250 ms",
      drop.firstPose < 250,
    ),
    tableRow(
      `drop ${fileSize} → labels on the timeline`,
      formatTime(drop.labels),
      "-",
      "500 ms",
      drop.labels < 500,
    ),
    tableRow(
      `drop one hour (${hourSize}) → labels on the timeline`,
      formatTime(hour.labels),
      "-",
      "8 s",
      hour.labels < 8000,
    ),
    tableRow(
      `folder of ${clips} clips of ${formatCount(frames)} frames`,
      formatTime(folder.time),
      `command line ${formatTime(native.folder)}`,
      "30 s, command line 10 s",
      folder.time < 30_000 && native.folder < 10_000,
    ),
    ...[
      ["opening one hour", hour.opening],
      ["scrubbing through one hour", hour.scrubbing],
      ["playing one hour", hour.playing],
      ["playing six characters", six],
      ["processing the folder", folder],
    ].map(([activity, load]) =>
      tableRow(
        `main thread while ${activity}: script per frame (95th percentile), longest task`,
        `${formatTime(load.script)}, ${formatTime(load.longest)}`,
        "-",
        "8 ms, 50 ms",
        isSmooth(load),
      ),
    ),
    tableRow(
      "download, wasm (Brotli)",
      formatKilobytes(sizes.wasm),
      "-",
      "250 KB",
      sizes.wasm <= 250_000,
    ),
    tableRow(
      "download, JavaScript (Brotli)",
      formatKilobytes(sizes.js),
      "-",
      "300 KB",
      sizes.js <= 300_000,
    ),
  ];
}

/** Returns the rows of the stages of a detection in 10,000 frames. */
function stageRows({ detect, redetect }) {
  const total = detect[10000];
  const cells = (time) => {
    const positive = Math.max(time, 0);
    return `${formatTime(positive)} | ${((100 * positive) / total).toFixed(0)} %`;
  };
  return [
    ["joint positions, heights and speeds", "the clip or an override changes", total - redetect.w],
    ["samples, norms and cells", "w changes", redetect.w - redetect.r],
    ["degrees, thresholds and labels", "r changes", redetect.r],
  ].map(([stage, when, time]) => `| ${stage} | ${when} | ${cells(time)} |`);
}

/** Returns the text of BENCHMARKS.md. */
export function toMarkdown(results) {
  const { core, app } = results;
  const longest = core.growth.at(-1);
  const growthRows = core.growth.map(
    ({ frames, bytes, parse, positions, detect }) =>
      `| ${formatCount(frames)} | ${formatMegabytes(bytes)} | ${formatTime(parse)} | ${formatTime(positions)} | ${formatTime(detect)} | ${((detect / frames) * 1000).toFixed(1)} µs |`,
  );
  const rows = [
    ...parsingRows(results),
    ...detectionRows(results),
    ...segmentationRows(results),
    ...appRows(results),
  ];
  return `# Benchmarks

\`npm run bench\` measures everything in this table and rewrites it. Machine: ${cpus().length} × ${cpus()[0]?.model.trim()}.
Unless stated otherwise, times are those of the WebAssembly module in Chromium on one thread.
Clips are generated (\`crate/synth\`) at 120 Hz, with the number format of recording software. Ratios
are comparable between machines, absolute figures are not. The reference three.js BVHLoader runs in
the same page; Python libraries run on the same machine. "Native" is the core without a browser,
measured with Criterion. Memory of the page is the peak of its process. Times of the main thread are
processor times, since software rendering competes for the same processors.

| task | result | reference | target | |
|---|---:|---:|---:|---|
${rows.join("\n")}

One hour (${formatCount(HOUR)} frames, ${formatMegabytes(longest.bytes)}): parsing ${formatTime(longest.parse)}, joint positions
${formatTime(longest.positions)}, detection ${formatTime(longest.detect)}, detection after a change of the window ${formatTime(longest.redetect)},
segmentation ${formatTime(longest.segment)}; the skeleton moves ${formatTime(app.hour.firstPose)} after the drop.

## Stages of a detection

The first detection in 10,000 frames takes ${formatTime(core.detect[10000])}. Results that do not depend on a changed
parameter are cached:

| stage | repeated when | time | fraction |
|---|---|---:|---:|
${stageRows(core).join("\n")}

## Growth with the length of a clip

| frames | file | parsing | joint positions | detection | per frame |
|---:|---:|---:|---:|---:|---:|
${growthRows.join("\n")}

![Time by number of frames: detection, parsing and joint positions](${chartFolder}/growth-time.svg)

![Memory by number of frames: after detection, after parsing, and size of the file](${chartFolder}/growth-memory.svg)

[docs/notes/performance.md](docs/notes/performance.md) explains these figures and records what was
tried.
`;
}
