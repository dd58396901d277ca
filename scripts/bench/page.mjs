/** Pages of a browser in which operations of the wasm module are measured. */

import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "../run.mjs";
import { benchFolder, urlPath } from "./clips.mjs";

/** Compiles the wasm module whose arithmetic runs at the peak of the processor. */
async function compilePeak(tree) {
  mkdirSync(benchFolder, { recursive: true });
  const source = join(tree, "tests/bench/peak.rs");
  const target = ["--target", "wasm32-unknown-unknown", "-C", "target-feature=+simd128"];
  const output = ["-O", "--crate-type", "cdylib", "-o", join(benchFolder, "peak.wasm")];
  await run("rustc", ["--edition", "2024", ...target, ...output, source]);
}

/**
 * Serves the page of a source tree.
 * @param {{ tree: string, launch: () => Promise<import("playwright").Browser> }} options
 */
export async function serveBenchPage({ tree, launch }) {
  await compilePeak(tree);
  const { createServer } = await import("vite");
  const server = await createServer({
    root: join(tree, "tests/bench"),
    publicDir: benchFolder,
    server: { fs: { allow: [tree] }, port: 0 },
    logLevel: "warn",
  });
  await server.listen();
  return {
    /** Opens the page in a newly started browser: wasm memory never shrinks. */
    async open() {
      const browser = await launch();
      const page = await browser.newPage();
      page.setDefaultTimeout(0);
      await page.goto(server.resolvedUrls.local[0]);
      await page.waitForFunction(() => document.title === "ready");
      const call = (name, ...args) =>
        page.evaluate(([name, args]) => globalThis.bench[name](...args), [name, args]);
      return {
        /** Opens the clip with this number of frames and returns its size in bytes. */
        open: (frames) => call("open", urlPath(frames)),
        /** Returns the mean time of an operation, in milliseconds. */
        measure: (operation, argument) => call("measure", operation, argument),
        call,
        rendererMemory: (field) => rendererMemory(browser, field),
        close: () => browser.close(),
      };
    },
    close: () => server.close(),
  };
}

/** Returns a field of the status of the page's process in bytes; undefined where there is none. */
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
