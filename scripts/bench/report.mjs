/** BENCHMARKS.md: every target with what was measured, and figures of growth. */

import { readFileSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { root } from "../run.mjs";
import { FOLDER, HOUR } from "./clips.mjs";
import { METHODS } from "./core.mjs";
import { figure } from "./figure.mjs";

const folder = "docs/results";
/** What a person adds to the figures stands below this line, and is kept. */
const BY_HAND = "## What was tried";

const ms = (value) =>
  value >= 1000 ? `${(value / 1000).toFixed(2)} s` : `${value.toPrecision(3)} ms`;
const times = (value) => `${value.toPrecision(3)} ×`;
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(bytes < 1e8 ? 1 : 0)} MB`;
const rate = (bytes, time) => `${(bytes / 1e3 / time).toFixed(0)} MB/s`;
const kilobytes = (bytes) => `${(bytes / 1000).toFixed(0)} KB`;
const count = (value) => Number(value).toLocaleString("en");

/** The figures of growth. */
export function figures(growth) {
  const frames = { title: "frames", text: count };
  const series = (label, value) => ({
    label,
    points: growth.map((row) => [row.frames, value(row)]),
  });
  const draw = (name, drawn) => writeFileSync(join(root, folder, name), figure(drawn));
  draw("growth-time.svg", {
    title: "Time over the length of a clip",
    x: frames,
    y: { title: "time", text: (value) => (value < 1000 ? `${value} ms` : `${value / 1000} s`) },
    series: [
      series("all parts labelled", (row) => row.detected),
      series("read", (row) => row.read),
      series("all joints placed", (row) => row.placed),
    ],
  });
  draw("growth-memory.svg", {
    title: "WebAssembly memory over the length of a clip",
    x: frames,
    y: { title: "memory", text: (value) => `${value} MB` },
    series: [
      series("most, once labelled", (row) => row.memory.labelled / 1e6),
      series("once read and shown", (row) => row.memory.shown / 1e6),
      series("the file", (row) => row.bytes / 1e6),
    ],
  });
}

/** A row of the table; without a target, or where nobody could measure, nothing is met or missed. */
const row = (work, ours, reference, target, isMet) => {
  const verdict = isMet ? "met" : "**missed**";
  return `| ${work} | ${ours} | ${reference} | ${target} | ${isMet === undefined ? "-" : verdict} |`;
};

function reading({ core: { read, memory, growth }, native }) {
  const hour = growth.at(-1);
  const of = ({ bytes, ours, loader }, least) => {
    const faster = loader / ours;
    const isMet = bytes / 1e3 / ours >= 250 && faster >= least;
    const reference = `BVHLoader ${rate(bytes, loader)}: ${times(faster)}`;
    return row(
      `read ${megabytes(bytes)}`,
      rate(bytes, ours),
      reference,
      `250 MB/s, ${least} ×`,
      isMet,
    );
  };
  const share = (memory) => memory / hour.bytes;
  const rows = [
    of(read.ten, 40),
    of(read.hundred, 40),
    row(
      `the same natively, ${megabytes(read.ten.bytes)}`,
      rate(read.ten.bytes, native.read),
      "-",
      "400 MB/s",
      read.ten.bytes / 1e3 / native.read >= 400,
    ),
  ];
  if (memory.ours && memory.loader) {
    const ratio = memory.loader.grown / memory.ours.grown;
    rows.push(
      row(
        `memory of the page to read ${megabytes(memory.ours.bytes)}`,
        megabytes(memory.ours.grown),
        `BVHLoader ${megabytes(memory.loader.grown)}: ${times(ratio)}`,
        "8 ×",
        ratio >= 8,
      ),
    );
  }
  for (const [what, amount] of [
    ["read and show", hour.memory.shown],
    ["label it too", hour.memory.labelled],
  ]) {
    const target = "2 × the file";
    rows.push(
      row(`wasm memory, an hour: ${what}`, times(share(amount)), "-", target, share(amount) <= 2),
    );
  }
  return rows;
}

function labelling({ core, native, references }) {
  const { detect, exact, published, relabel, growth } = core;
  const targets = { 300: 2, 1000: 10, 10000: 100 };
  const rows = Object.entries(targets).flatMap(([frames, target]) => {
    const time = detect[frames];
    const known = `all pairs ${ms(exact[frames])}, native ${ms(native.detect[frames])}`;
    const whole = row(`detect ${count(frames)} frames`, ms(time), known, ms(target), time < target);
    return published[frames] ? [whole, alike(frames, published[frames], references)] : [whole];
  });
  const hour = growth.at(-1);
  return [
    ...rows,
    row(`detect ${count(HOUR)} frames`, ms(hour.detected), "-", "2 s", hour.detected < 2000),
    row("label 10,000 frames anew, another r", ms(relabel.r), "-", "16.7 ms", relabel.r < 16.7),
  ];
}

/** What the references do: they cluster toes that were placed before, once. */
function alike(frames, { whole, clustering }, references) {
  const known = [
    ["scikit-learn", references.sklearn?.[frames]],
    ["dense eigensolver", references.dense?.[frames]],
  ]
    .filter(([, others]) => others)
    .map(([title, { middle, least }]) => {
      const quickest = `at least ${ms(least)}: ${times(least / clustering)}`;
      return `${title} ${ms(middle)}: ${times(middle / clustering)} (${quickest})`;
    });
  const target = { 300: 100 }[frames];
  const other = target && references.sklearn?.[frames];
  return row(
    "cluster its toes as published",
    `${ms(clustering)}, with placing them ${ms(whole)}`,
    known.join(", ") || "-",
    target ? times(target) : "-",
    other && other.middle / clustering >= target,
  );
}

function cutting({ core: { segment }, native }) {
  return METHODS.map((method) => {
    const target = method === "mvu" ? 4000 : 300;
    const reference = method === "auto" ? `native ${ms(native.cut)}` : "-";
    const time = segment[method];
    return row(`cut 10,000 frames: ${method}`, ms(time), reference, ms(target), time < target);
  });
}

function using({ app, native, sizes, core: { read, growth } }) {
  const file = megabytes(read.ten.bytes);
  const { drop, hour, six, folder } = app;
  const { clips, frames } = FOLDER;
  const smooth = ({ script, longest }) => script < 8 && longest < 50;
  const main = ({ script, longest }) => `${ms(script)}, ${ms(longest)}`;
  const long = megabytes(growth.at(-1).bytes);
  return [
    row(`drop ${file} → moving skeleton`, ms(drop.moving), "-", "250 ms", drop.moving < 250),
    row(
      `drop ${file} → labels on the timeline`,
      ms(drop.labelled),
      "-",
      "500 ms",
      drop.labelled < 500,
    ),
    row(
      `drop an hour (${long}) → labels on the timeline`,
      ms(hour.labelled),
      "-",
      "8 s",
      hour.labelled < 8000,
    ),
    row(
      `folder of ${clips} clips of ${count(frames)} frames`,
      ms(folder.time),
      `command line ${ms(native.folder)}`,
      "30 s, command line 10 s",
      folder.time < 30_000 && native.folder < 10_000,
    ),
    ...[
      ["an hour is opened", hour.opening],
      ["an hour is scrubbed through", hour.scrubbing],
      ["an hour is played", hour.playing],
      ["six characters are played", six],
      ["the folder is labelled", folder],
    ].map(([when, seen]) =>
      row(
        `main thread while ${when}: script per frame (95th percentile), longest task`,
        main(seen),
        "-",
        "8 ms, 50 ms",
        smooth(seen),
      ),
    ),
    row("download, wasm (brotli)", kilobytes(sizes.wasm), "-", "250 KB", sizes.wasm <= 250_000),
    row("download, JavaScript (brotli)", kilobytes(sizes.js), "-", "300 KB", sizes.js <= 300_000),
  ];
}

function stages({ detect, relabel }) {
  const whole = detect[10000];
  const share = (time) =>
    `${ms(Math.max(time, 0))} | ${((100 * Math.max(time, 0)) / whole).toFixed(0)} %`;
  return [
    ["joints placed, heights and speeds", "anything but parameters changes", whole - relabel.w],
    ["samples, norms and cells", "w changes", relabel.w - relabel.r],
    ["degrees, thresholds and labels", "r changes", relabel.r],
  ].map(([stage, when, time]) => `| ${stage} | ${when} | ${share(time)} |`);
}

/** The page; what was written by hand of the one before stays. */
export function report(measured) {
  const { core, app } = measured;
  const hour = core.growth.at(-1);
  const before = readFileSync(join(root, "BENCHMARKS.md"), "utf8");
  const kept = before.includes(BY_HAND) ? before.slice(before.indexOf(BY_HAND)) : `${BY_HAND}\n`;
  const growth = core.growth.map(
    ({ frames, bytes, read, placed, detected }) =>
      `| ${count(frames)} | ${megabytes(bytes)} | ${ms(read)} | ${ms(placed)} | ${ms(detected)} | ${((detected / frames) * 1000).toFixed(1)} µs |`,
  );
  return `# Benchmarks

Measured in Chromium's WebAssembly, one thread unless it says otherwise, on ${cpus().length} ×
${cpus()[0]?.model.trim()}; generated clips at 120 Hz as recorders write them
(\`crate/synth\`). \`npm run bench\` measures anew. Ratios travel between machines, absolute
figures do not. References run in the same page (three.js BVHLoader), or beside it (Python's
libraries); "native" is the same core without a browser, by Criterion. Memory of the page is
what the system counts for its process at most; times of the main thread are of the processor,
as a browser without a graphics card draws on the same processors.

| work | ours | reference | target | |
|---|---:|---:|---:|---|
${[...reading(measured), ...labelling(measured), ...cutting(measured), ...using(measured)].join("\n")}

An hour (${count(HOUR)} frames, ${megabytes(hour.bytes)}): read in ${ms(hour.read)}, all joints placed in
${ms(hour.placed)}, labelled in ${ms(hour.detected)}, anew with another window in ${ms(hour.relabelled)},
cut into actions in ${ms(hour.cut)}; its skeleton moves after ${ms(app.hour.moving)}.

## Where the time goes

Labelling 10,000 frames takes ${ms(core.detect[10000])} the first time. What does not depend on a slider is
kept while it moves:

| stage | done when | time | share |
|---|---|---:|---:|
${stages(core).join("\n")}

## How time grows

| frames | file | read | joints placed | labelled | per frame |
|---:|---:|---:|---:|---:|---:|
${growth.join("\n")}

![Time over frames: labelling, reading and placing joints](${folder}/growth-time.svg)

![Memory over frames: labelled, read and shown, and the file](${folder}/growth-memory.svg)

${kept}`;
}
