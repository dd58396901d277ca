/** `npm run bench`: measures speed, memory and size beside others, and writes BENCHMARKS.md. */

import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { browser } from "./browser.mjs";
import { buildSite } from "./build.mjs";
import { figure } from "./figure.mjs";
import { ask, main, root, run, step } from "./run.mjs";
import { CRATES, setup } from "./setup.mjs";

const clips = join(root, "target/bench");
const figures = "docs/results";
/** Frames of the generated clips at 120 Hz, from ten thousand to an hour; 26,000 are about ten megabytes. */
const LENGTHS = [10_000, 26_000, 50_000, 100_000, 200_000, 432_000];
const METHODS = ["auto", "pca", "pca-tail", "ppca", "lsd", "mvu"];

await main(async () => {
  await setup();
  await buildSite();
  const { chromium: executablePath } = await browser();
  await generate();
  const others = references();

  step("Measuring in the browser");
  const { chromium } = await import("playwright");
  const { createServer } = await import("vite");
  const server = await createServer({
    root: join(root, "tests/bench"),
    publicDir: clips,
    server: { fs: { allow: [root] } },
    logLevel: "warn",
  });
  await server.listen();
  const engine = await chromium.launch({
    executablePath,
    args: ["--no-sandbox", "--enable-precise-memory-info", "--js-flags=--expose-gc"],
  });
  const measured = {};
  try {
    const page = await engine.newPage();
    page.setDefaultTimeout(0);
    await page.goto(server.resolvedUrls.local[0]);
    await page.waitForFunction(() => document.title === "ready");
    const call = (name, ...args) =>
      page.evaluate(([name, args]) => globalThis.bench[name](...args), [name, args]);
    await short(call, measured);
    // Pages of their own: memory must not have been grown by others.
    const anew = async () => {
      await page.reload();
      await page.waitForFunction(() => document.title === "ready");
    };
    await growth(call, anew, measured);
    await anew();
    measured.loader = await call("loader", "/26000/long.bvh", 3);
    measured.drop = await drop(engine);
  } finally {
    await engine.close();
    await server.close();
  }
  draw(measured.growth);
  const text = report(measured, others, sizes());
  writeFileSync(join(root, "BENCHMARKS.md"), text);
  console.log(`\n${text}\nBENCHMARKS.md is written.`);
});

/** The clips, unless they are there. */
async function generate() {
  for (const frames of LENGTHS) {
    const folder = join(clips, String(frames));
    if (existsSync(join(folder, "long.bvh"))) continue;
    step(`Generating ${frames} frames`);
    mkdirSync(folder, { recursive: true });
    const synth = ["run", "--locked", "--release", "-q", "-p", "plantigrade-synth", "--"];
    const what = ["--set", "long", "--frames", String(frames), "--out", folder];
    await run("cargo", [...synth, ...what], { source: CRATES });
  }
}

/** What Python's libraries need, where they are installed. */
function references() {
  const output = ask("python3", [join(root, "tests/bench/reference.py")]);
  return output ? JSON.parse(output) : {};
}

/** Clips of up to ten thousand frames. */
async function short(call, measured) {
  measured.parse = await call("parse", "/26000/long.bvh", 5);
  await call("parse", "/10000/long.bvh", 1);
  measured.positions = await call("positions", 3);
  measured.detect = { 10000: await call("detect", 5, false) };
  measured.exact = { 10000: await call("detect", 1, true) };
  measured.relabel = { w: await call("relabel", 5, "w"), r: await call("relabel", 5, "r") };
  measured.segment = {};
  for (const method of METHODS) {
    measured.segment[method] = await call("segment", method, method === "mvu" ? 1 : 3);
  }
  for (const frames of [1000, 300]) {
    await call("cut", frames);
    measured.detect[frames] = await call("detect", 20, false);
    measured.exact[frames] = await call("detect", 5, true);
  }
}

/** How time and memory grow with the length of a clip, up to an hour. */
async function growth(call, anew, measured) {
  measured.growth = [];
  for (const frames of LENGTHS) {
    await anew();
    const read = await call("parse", `/${frames}/long.bvh`, 1);
    const placed = await call("positions", 1);
    const shown = await call("memory");
    const detected = await call("detect", 2, false);
    const labelled = await call("memory");
    const { time, bytes, before } = read;
    const memory = { read: read.memory, shown, labelled };
    measured.growth.push({ frames, bytes, before, read: time, placed, detected, memory });
    measured.detect[frames] = Math.min(
      detected,
      measured.detect[frames] ?? Number.POSITIVE_INFINITY,
    );
  }
  measured.hourAuto = await call("segment", "auto", 1);
}

/** The figures of growth. */
function draw(growth) {
  const thousands = { title: "frames", text: (value) => value.toLocaleString("en") };
  const series = (label, value) => ({
    label,
    points: growth.map((row) => [row.frames, value(row)]),
  });
  const seconds = {
    title: "time",
    text: (value) => (value < 1000 ? `${value} ms` : `${value / 1000} s`),
  };
  const megabytes = { title: "memory", text: (value) => `${value} MB` };
  const save = (name, drawn) => writeFileSync(join(root, figures, name), figure(drawn));
  save("growth-time.svg", {
    title: "Time over the length of a clip",
    x: thousands,
    y: seconds,
    series: [
      series("all parts labelled", (row) => row.detected),
      series("read", (row) => row.read),
      series("all joints placed", (row) => row.placed),
    ],
  });
  save("growth-memory.svg", {
    title: "WebAssembly memory over the length of a clip",
    x: thousands,
    y: megabytes,
    series: [
      series("most, once labelled", (row) => row.memory.labelled / 1e6),
      series("once read and shown", (row) => row.memory.shown / 1e6),
      series("the file", (row) => row.bytes / 1e6),
    ],
  });
}

/** From the moment that the page is given ten megabytes to labels on the timeline, in milliseconds. */
async function drop(engine) {
  const { preview } = await import("vite");
  const site = await preview({ root: join(root, "web"), logLevel: "warn" });
  const page = await engine.newPage();
  try {
    await page.goto(site.resolvedUrls.local[0], { waitUntil: "networkidle" });
    // Timed in the page: handing the file over takes the browser's driver longer than the app.
    const labelled = page.evaluate(
      () =>
        new Promise((resolve) => {
          let start;
          const begin = () => {
            start = performance.now();
          };
          addEventListener("change", begin, { capture: true, once: true });
          new MutationObserver(() => {
            if (start && document.querySelector(".pills")) resolve(performance.now() - start);
          }).observe(document.body, { childList: true, subtree: true });
        }),
    );
    await page.setInputFiles("input[type=file]", join(clips, "26000/long.bvh"));
    return await labelled;
  } finally {
    await page.close();
    await site.close();
  }
}

/** Bytes to download, compressed. */
function sizes() {
  const compressed = (path) =>
    brotliCompressSync(readFileSync(path), {
      params: { [constants.BROTLI_PARAM_QUALITY]: 11 },
    }).length;
  const assets = join(root, "web/dist/assets");
  const total = (ending) =>
    readdirSync(assets)
      .filter((name) => name.endsWith(ending) && statSync(join(assets, name)).isFile())
      .reduce((sum, name) => sum + compressed(join(assets, name)), 0);
  return { wasm: total(".wasm"), js: total(".js") };
}

/** The page: every target with what was measured. */
function report(m, others, size) {
  const rate = (parsed) => parsed.bytes / 1e3 / parsed.time;
  const hour = m.growth.at(-1);
  const grown = (memory) => (memory - hour.before) / hour.bytes;
  const ms = (value) =>
    value >= 1000 ? `${(value / 1000).toFixed(2)} s` : `${value.toPrecision(3)} ms`;
  const times = (value) => `${value.toPrecision(3)} ×`;
  const rows = [];
  const row = (what, ours, reference, target, isMet) =>
    rows.push(`| ${what} | ${ours} | ${reference} | ${target} | ${isMet ? "met" : "**missed**"} |`);
  const faster = m.loader.time / m.parse.time;
  const megabytes = (m.parse.bytes / 1e6).toFixed(1);
  row(
    `read ${megabytes} MB`,
    `${rate(m.parse).toFixed(0)} MB/s`,
    `BVHLoader ${rate(m.loader).toFixed(1)} MB/s: ${times(faster)}`,
    "250 MB/s, 40 ×",
    rate(m.parse) >= 250 && faster >= 40,
  );
  const heap = m.loader.grown / m.loader.bytes;
  const hourMemory = grown(hour.memory.shown);
  row(
    "memory to read and show an hour, of the file",
    times(hourMemory),
    `BVHLoader ${times(heap)} (${megabytes} MB)`,
    "2 ×, an eighth of BVHLoader's",
    hourMemory <= 2 && hourMemory * 8 <= heap,
  );
  const most = grown(hour.memory.labelled);
  row("memory to label it too, of the file", times(most), "-", "2 ×", most <= 2);
  const targets = { 300: 2, 1000: 10, 10000: 100, 432000: 2000 };
  for (const [frames, target] of Object.entries(targets)) {
    const known = ["sklearn", "dense"]
      .filter((name) => others[name]?.[frames])
      .map((name) => {
        const title = name === "sklearn" ? "scikit-learn" : "dense eigensolver";
        const ratio = (others[name][frames] * 1000) / m.detect[frames];
        return `${title} ${ms(others[name][frames] * 1000)}: ${times(ratio)}`;
      });
    if (m.exact[frames]) known.push(`all pairs ${ms(m.exact[frames])}`);
    row(
      `detect ${Number(frames).toLocaleString("en")} frames, all parts`,
      ms(m.detect[frames]),
      known.join(", ") || "-",
      `${ms(target)}`,
      m.detect[frames] < target,
    );
  }
  row("label 10,000 frames anew, another r", ms(m.relabel.r), "-", "16.7 ms", m.relabel.r < 16.7);
  for (const method of METHODS) {
    const target = method === "mvu" ? 4000 : 300;
    const ours = m.segment[method];
    row(`cut 10,000 frames: ${method}`, ms(ours), "-", ms(target), ours < target);
  }
  row(
    `drop ${megabytes} MB → labels on the timeline`,
    ms(m.drop),
    "-",
    "500 ms (10 MB)",
    m.drop < 500,
  );
  const kilobytes = (bytes) => `${(bytes / 1000).toFixed(0)} KB`;
  row("download, wasm (brotli)", kilobytes(size.wasm), "-", "250 KB", size.wasm <= 250_000);
  row("download, JavaScript (brotli)", kilobytes(size.js), "-", "300 KB", size.js <= 300_000);

  const growth = Object.entries(m.detect).map(
    ([frames, time]) =>
      `| ${Number(frames).toLocaleString("en")} | ${ms(time)} | ${((time / frames) * 1000).toFixed(1)} µs |`,
  );
  const whole = m.detect[10000];
  const share = (time) =>
    `${ms(Math.max(time, 0))} | ${((100 * Math.max(time, 0)) / whole).toFixed(0)} %`;
  const stages = [
    ["joints placed, heights and speeds", "anything but parameters changes", whole - m.relabel.w],
    ["samples, norms and cells", "w changes", m.relabel.w - m.relabel.r],
    ["degrees, thresholds and labels", "r changes", m.relabel.r],
  ].map(([stage, when, time]) => `| ${stage} | ${when} | ${share(time)} |`);
  return `# Benchmarks

Measured in Chromium's WebAssembly, one thread, on ${cpus().length} × ${cpus()[0]?.model.trim()};
generated clips at 120 Hz (\`crate/synth\`). \`npm run bench\` measures anew. Ratios travel
between machines, absolute figures do not. References run in the same page
(three.js BVHLoader) or beside it (Python, where it is installed).

| work | ours | reference | target | |
|---|---:|---:|---:|---|
${rows.join("\n")}

An hour (432,000 frames, ${(hour.bytes / 1e6).toFixed(0)} MB): read in ${ms(hour.read)},
labelled in ${ms(m.detect[432000])}, cut into actions in ${ms(m.hourAuto)}, all joints placed
in ${ms(hour.placed)}.

## Where the time goes

Labelling 10,000 frames takes ${ms(whole)} the first time. What does not depend on a slider is
kept while it moves:

| stage | done when | time | share |
|---|---|---:|---:|
${stages.join("\n")}

## How time and memory grow

| frames | time | per frame |
|---:|---:|---:|
${growth.join("\n")}

![Time over frames: labelling, reading and placing joints](${figures}/growth-time.svg)

![Memory over frames: labelled, read and shown, and the file](${figures}/growth-memory.svg)
`;
}
