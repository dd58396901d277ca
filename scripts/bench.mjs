/** `npm run bench`: measures speed, memory and size beside others, and writes BENCHMARKS.md. */

import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { browser } from "./browser.mjs";
import { buildSite } from "./build.mjs";
import { ask, main, root, run, step } from "./run.mjs";
import { CRATES, setup } from "./setup.mjs";

const clips = join(root, "target/bench");
/** Frames of the generated clips at 120 Hz: ten thousand, about ten megabytes, and an hour. */
const LENGTHS = [10_000, 26_000, 432_000];
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
    await hour(call, measured);
    // A page of its own: its heap must not have been grown by others.
    await page.reload();
    await page.waitForFunction(() => document.title === "ready");
    measured.loader = await call("loader", "/26000/long.bvh", 3);
    measured.drop = await drop(engine);
  } finally {
    await engine.close();
    await server.close();
  }
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

/** The long clip, and how time grows up to it. */
async function hour(call, measured) {
  measured.hour = await call("parse", "/432000/long.bvh", 1);
  measured.detect[432000] = await call("detect", 2, false);
  measured.hourAuto = await call("segment", "auto", 1);
  measured.hourPositions = await call("positions", 1);
  for (const frames of [200000, 100000, 50000, 20000]) {
    await call("cut", frames);
    measured.detect[frames] = await call("detect", 2, false);
  }
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
  const grown = (parsed) => (parsed.memory - parsed.before) / parsed.bytes;
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
  const hourMemory = grown(m.hour);
  row(
    "memory to read an hour, of the file",
    times(hourMemory),
    `BVHLoader ${times(heap)} (${megabytes} MB)`,
    "2 ×, an eighth of BVHLoader's",
    hourMemory <= 2 && hourMemory * 8 <= heap,
  );
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
  return `# Benchmarks

Measured in Chromium's WebAssembly, one thread, on ${cpus().length} × ${cpus()[0]?.model.trim()};
generated clips at 120 Hz (\`crate/synth\`). \`npm run bench\` measures anew. Ratios travel
between machines, absolute figures do not. References run in the same page
(three.js BVHLoader) or beside it (Python, where it is installed).

| work | ours | reference | target | |
|---|---:|---:|---:|---|
${rows.join("\n")}

An hour (432,000 frames, ${(m.hour.bytes / 1e6).toFixed(0)} MB): read in ${ms(m.hour.time)},
labelled in ${ms(m.detect[432000])}, cut into actions in ${ms(m.hourAuto)}, all joints placed
in ${ms(m.hourPositions)}.

## How detection grows

| frames | time | per frame |
|---:|---:|---:|
${growth.join("\n")}
`;
}
