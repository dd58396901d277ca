/** The WebAssembly module in a page of its own, beside three.js' loader in the same page. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { root, step } from "../run.mjs";
import { address, folder, HOUR, HUNDRED_MEGABYTES, LENGTHS, TEN_MEGABYTES } from "./clips.mjs";

export const METHODS = ["auto", "pca", "pca-tail", "ppca", "lsd", "mvu"];

/** @param {() => Promise<import("playwright").Browser>} launch */
export async function core(launch) {
  step("Measuring the WebAssembly module");
  const { createServer } = await import("vite");
  const server = await createServer({
    root: join(root, "tests/bench"),
    publicDir: folder,
    server: { fs: { allow: [root] } },
    logLevel: "warn",
  });
  await server.listen();
  /** Runs some work in a page of a browser that has done nothing else. */
  const alone = async (work) => {
    const engine = await launch();
    try {
      const page = await engine.newPage();
      page.setDefaultTimeout(0);
      await page.goto(server.resolvedUrls.local[0]);
      await page.waitForFunction(() => document.title === "ready");
      const call = (name, ...args) =>
        page.evaluate(([name, args]) => globalThis.bench[name](...args), [name, args]);
      return await work(call, engine);
    } finally {
      await engine.close();
    }
  };
  try {
    return {
      read: {
        ten: await alone((call) => read(call, TEN_MEGABYTES)),
        hundred: await alone((call) => read(call, HUNDRED_MEGABYTES)),
      },
      memory: {
        ours: await alone((call, engine) => grown(engine, () => call("parse", HUNDRED, 1))),
        loader: await alone((call, engine) => grown(engine, () => call("loader", HUNDRED, 1))),
      },
      ...(await alone(short)),
      growth: await growth(alone),
    };
  } finally {
    await server.close();
  }
}

const HUNDRED = address(HUNDRED_MEGABYTES);

/** The same file by both, in the same page; what each throws away is not the other's to collect. */
async function read(call, frames) {
  const url = address(frames);
  const ours = await call("parse", url, 5);
  return { bytes: ours.bytes, ours: ours.time, loader: (await call("loader", url, 3)).time };
}

/**
 * What the page's process takes at most, as the system counts it, while some work is done, beyond
 * what it took before; undefined where the system does not tell.
 */
async function grown(engine, work) {
  const before = await resident(engine, "VmRSS");
  const { bytes } = await work();
  const most = await resident(engine, "VmHWM");
  return before && most ? { bytes, grown: most - before } : undefined;
}

async function resident(engine, what) {
  const session = await engine.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  const pages = processInfo.filter(({ type }) => type === "renderer");
  try {
    const amounts = pages.map(({ id }) => {
      const status = readFileSync(`/proc/${id}/status`, "utf8");
      return 1024 * Number(new RegExp(`${what}:\\s+(\\d+) kB`).exec(status)?.[1]);
    });
    return Math.max(...amounts);
  } catch {
    return undefined;
  }
}

/** Clips of up to ten thousand frames, in milliseconds. */
async function short(call) {
  await call("parse", address(10_000), 1);
  const detect = { 10000: await call("detect", 15, false) };
  const exact = { 10000: await call("detect", 1, true) };
  const relabel = { w: await call("relabel", 15, "w"), r: await call("relabel", 15, "r") };
  const segment = {};
  for (const method of METHODS) {
    segment[method] = await call("segment", method, method === "mvu" ? 1 : 3);
  }
  const [published, toes] = [{}, {}];
  for (const frames of [1000, 300]) {
    await call("cut", frames);
    detect[frames] = await call("detect", 21, false);
    exact[frames] = await call("detect", 5, true);
    published[frames] = {
      whole: await call("detect", 21, false, "paper"),
      clustering: await call("relabel", 21, "r", "paper"),
    };
    toes[frames] = await call("toes");
  }
  return { detect, exact, published, relabel, segment, toes };
}

/** How time and memory grow with the length of a clip, up to an hour. */
async function growth(alone) {
  const rows = [];
  for (const frames of LENGTHS) {
    // A page of its own: memory must not have been grown by others.
    const row = await alone(async (call) => {
      const { time, bytes, before } = await call("parse", address(frames), 1);
      const placed = await call("positions", 1);
      const shown = await call("memory");
      const detected = await call("detect", frames < 50_000 ? 15 : 5, false);
      const labelled = await call("memory");
      const others = frames === HOUR ? await hour(call) : {};
      const memory = { shown: shown - before, labelled: labelled - before };
      return { frames, bytes, read: time, placed, detected, memory, ...others };
    });
    rows.push(row);
  }
  return rows;
}

/** What else an hour is asked for. */
async function hour(call) {
  return { relabelled: await call("relabel", 3, "w"), cut: await call("segment", "auto", 1) };
}
