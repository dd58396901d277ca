/** Benchmarks of the WebAssembly module and of three.js' BVHLoader in the same page. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { root, step } from "../run.mjs";
import { benchFolder, HOUR, HUNDRED_MEGABYTES, LENGTHS, TEN_MEGABYTES, urlPath } from "./clips.mjs";

export const METHODS = ["auto", "pca", "pca-tail", "ppca", "lsd", "mvu"];

/** @param {() => Promise<import("playwright").Browser>} launch */
export async function measureCore(launch) {
  step("Measuring the WebAssembly module");
  const { createServer } = await import("vite");
  const server = await createServer({
    root: join(root, "tests/bench"),
    publicDir: benchFolder,
    server: { fs: { allow: [root] } },
    logLevel: "warn",
  });
  await server.listen();
  /** Runs a measurement in a page of a newly started browser. */
  const inNewPage = async (measure) => {
    const browser = await launch();
    try {
      const page = await browser.newPage();
      page.setDefaultTimeout(0);
      await page.goto(server.resolvedUrls.local[0]);
      await page.waitForFunction(() => document.title === "ready");
      const call = (name, ...args) =>
        page.evaluate(([name, args]) => globalThis.bench[name](...args), [name, args]);
      return await measure(call, browser);
    } finally {
      await browser.close();
    }
  };
  try {
    return {
      parsing: {
        ten: await inNewPage((call) => measureParsing(call, TEN_MEGABYTES)),
        hundred: await inNewPage((call) => measureParsing(call, HUNDRED_MEGABYTES)),
      },
      memory: {
        ours: await inNewPage((call, browser) =>
          memoryGrowth(browser, () => call("parse", HUNDRED_URL, 1)),
        ),
        loader: await inNewPage((call, browser) =>
          memoryGrowth(browser, () => call("parseWithLoader", HUNDRED_URL, 1)),
        ),
      },
      ...(await inNewPage(measureShortClips)),
      growth: await measureGrowth(inNewPage),
    };
  } finally {
    await server.close();
  }
}

const HUNDRED_URL = urlPath(HUNDRED_MEGABYTES);

/** Measures both readers on the same file, in the same page. */
async function measureParsing(call, frames) {
  const url = urlPath(frames);
  const ours = await call("parse", url, 5);
  return {
    bytes: ours.bytes,
    ours: ours.time,
    loader: (await call("parseWithLoader", url, 3)).time,
  };
}

/**
 * Returns the peak memory of the page's process during a measurement, minus its memory before, in
 * bytes; undefined if the system does not report it.
 */
async function memoryGrowth(browser, measure) {
  const before = await rendererMemory(browser, "VmRSS");
  const { bytes } = await measure();
  const peak = await rendererMemory(browser, "VmHWM");
  return before && peak ? { bytes, growth: peak - before } : undefined;
}

async function rendererMemory(browser, field) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  const pages = processInfo.filter(({ type }) => type === "renderer");
  try {
    const amounts = pages.map(({ id }) => {
      const status = readFileSync(`/proc/${id}/status`, "utf8");
      return 1024 * Number(new RegExp(`${field}:\\s+(\\d+) kB`).exec(status)?.[1]);
    });
    return Math.max(...amounts);
  } catch {
    return undefined;
  }
}

/** Measures clips of up to 10,000 frames, in milliseconds. */
async function measureShortClips(call) {
  await call("parse", urlPath(10_000), 1);
  const detect = { 10000: await call("detect", 15, false) };
  const exact = { 10000: await call("detect", 1, true) };
  const redetect = { w: await call("redetect", 15, "w"), r: await call("redetect", 15, "r") };
  const segment = {};
  for (const method of METHODS) {
    segment[method] = await call("segment", method, method === "mvu" ? 1 : 3);
  }
  const [published, toeSignals] = [{}, {}];
  for (const frames of [1000, 300]) {
    await call("truncate", frames);
    detect[frames] = await call("detect", 21, false);
    exact[frames] = await call("detect", 5, true);
    published[frames] = {
      total: await call("detect", 21, false, "paper"),
      clustering: await call("redetect", 21, "r", "paper"),
    };
    toeSignals[frames] = await call("toeSignals");
  }
  return { detect, exact, published, redetect, segment, toeSignals };
}

/** Measures time and memory for clips of increasing length. */
async function measureGrowth(inNewPage) {
  const rows = [];
  for (const frames of LENGTHS) {
    // In a new page, since wasm memory never shrinks.
    const row = await inNewPage(async (call) => {
      const { time, bytes, before } = await call("parse", urlPath(frames), 1);
      const positions = await call("positions", 1);
      const afterParsing = await call("memoryBytes");
      const detect = await call("detect", frames < 50_000 ? 15 : 5, false);
      const afterDetection = await call("memoryBytes");
      const more = frames === HOUR ? await measureHour(call) : {};
      const memory = { parsed: afterParsing - before, detected: afterDetection - before };
      return { frames, bytes, parse: time, positions, detect, memory, ...more };
    });
    rows.push(row);
  }
  return rows;
}

/** Measures further operations on the longest clip. */
async function measureHour(call) {
  return { redetect: await call("redetect", 3, "w"), segment: await call("segment", "auto", 1) };
}
