/** Writes BENCHMARKS.md: the measurements with their targets, and charts of growth. */

import { writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { root } from "../run.mjs";
import { lineChart } from "./line-chart.mjs";
import { isMet } from "./pairs.mjs";

const chartFolder = "docs/results";

const formatTime = (value) =>
  value >= 1000 ? `${(value / 1000).toFixed(2)} s` : `${value.toPrecision(3)} ms`;
const formatMegabytes = (bytes) => `${(bytes / 1e6).toFixed(bytes < 1e8 ? 1 : 0)} MB`;
const formatCount = (value) => Number(value).toLocaleString("en");
/** Formats a ratio with three digits. */
const formatRatio = (value) =>
  value >= 100 ? value.toFixed(0) : value.toFixed(value >= 10 ? 1 : value >= 0.1 ? 2 : 3);

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
      series("reading", (row) => row.parse),
      series("joint positions", (row) => row.positions),
    ],
  });
  write("growth-memory.svg", {
    title: "WebAssembly memory by length of the clip",
    x,
    y: { title: "memory", text: (value) => `${value} MB` },
    series: [
      series("after detection", (row) => row.memory.detected / 1e6),
      series("after reading", (row) => row.memory.parsed / 1e6),
      series("file", (row) => row.bytes / 1e6),
    ],
  });
}

/** Returns a row as a line of a Markdown table. */
export function toLine(row) {
  const { work, reference, ours, referenceValue, ratio, bound, target, text = formatTime } = row;
  const { median, low, high } = ratio;
  const interval = low === high ? "" : ` (${formatRatio(low)}–${formatRatio(high)})`;
  const met = { true: "met", false: "**missed**", undefined: "-" }[isMet(row)];
  const limit =
    target === undefined ? "-" : `${bound === "at least" ? "≥" : "≤"} ${formatRatio(target)}`;
  const cells = [
    work,
    text(ours),
    `${reference}: ${text(referenceValue)}`,
    `${formatRatio(median)}${interval}`,
    limit,
    met,
  ];
  return `| ${cells.join(" | ")} |`;
}

/** Returns a Markdown table of rows. */
export const toTable = (rows) =>
  [
    "| work | time | reference | ratio | target | |",
    "|---|---:|---|---:|---:|---|",
    ...rows.map(toLine),
  ].join("\n");

/**
 * Returns the text of BENCHMARKS.md.
 * @param {{ rows: import("./pairs.mjs").Row[], growth: object[] }} results
 */
export function toMarkdown({ rows, growth }) {
  const growthRows = growth.map(
    ({ frames, bytes, parse, positions, detect }) =>
      `| ${formatCount(frames)} | ${formatMegabytes(bytes)} | ${formatTime(parse)} | ${formatTime(positions)} | ${formatTime(detect)} | ${((detect / frames) * 1000).toFixed(1)} µs |`,
  );
  const results = rows.map(isMet).filter((met) => met !== undefined);
  return `# Benchmarks

\`npm run bench\` measures everything on this page and rewrites it. The machine of this run has
${cpus().length} × ${cpus()[0]?.model.trim()}; ${results.filter(Boolean).length} of ${results.length} targets are met.

Times differ from machine to machine and from day to day, so targets are ratios to a reference that is
measured in the same run. Both alternate, and each pair gives a ratio: the table has its median and,
in parentheses, the 95 % confidence interval of the median. Pairs are measured until the interval is
within ±3 %, or until 20 s have passed. A target is met only if the whole interval meets it. Ratios with
targets of at least (≥) are how many times as fast the work is as the reference; those of at most (≤) are
its time as a multiple of that of the reference. Times are medians.

Unless stated otherwise, work is done by the WebAssembly module in Chromium on one thread, and
"native" is the same code without a browser. Labelling is a first detection of all parts of both feet
with everything that it needs from the clip. Clips are generated (\`crate/synth\`) at 120 Hz, with the
number format of recording software. Python libraries run after the work that they are compared with,
because their threads would disturb it. Memory of the page is the peak of its process. Times of the main
thread are processor times, since software rendering competes for the same processors.
\`npm run bench -- --against REF\` compares the working tree with another commit.

${toTable(rows)}

## Growth with the length of a clip

| frames | file | reading | joint positions | detection | per frame |
|---:|---:|---:|---:|---:|---:|
${growthRows.join("\n")}

![Time by number of frames: detection, reading and joint positions](${chartFolder}/growth-time.svg)

![Memory by number of frames: after detection, after reading, and size of the file](${chartFolder}/growth-memory.svg)

[docs/notes/performance.md](docs/notes/performance.md) explains these figures and records what was
tried.
`;
}
