/** `npm run bench`: measures speed, memory and download size, and writes BENCHMARKS.md. */

import { readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { browser } from "../browser.mjs";
import { buildSite } from "../build.mjs";
import { main, root } from "../run.mjs";
import { setup } from "../setup.mjs";
import { measureApp } from "./app.mjs";
import { generateClips } from "./clips.mjs";
import { measureCore } from "./core.mjs";
import { measureNative } from "./native.mjs";
import { measureReferences } from "./references.mjs";
import { toMarkdown, writeCharts } from "./report.mjs";

await main(async () => {
  await setup();
  await buildSite();
  const { chromium: executablePath } = await browser();
  await generateClips();
  const { chromium } = await import("playwright");
  const launch = () => chromium.launch({ executablePath, args: ["--no-sandbox"] });
  const coreResults = await measureCore(launch);
  const results = {
    core: coreResults,
    references: measureReferences(coreResults.toeSignals),
    native: await measureNative(),
    app: await measureApp(launch),
    sizes: downloadSizes(),
  };
  writeCharts(results.core.growth);
  const markdown = toMarkdown(results);
  writeFileSync(join(root, "BENCHMARKS.md"), markdown);
  console.log(`\n${markdown}\nWrote BENCHMARKS.md.`);
});

/** Returns the sizes of the wasm module and of all scripts, compressed with Brotli, in bytes. */
function downloadSizes() {
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
