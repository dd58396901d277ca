/** `npm run bench`: measures speed, memory and size beside others, and writes BENCHMARKS.md. */

import { readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { browser } from "../browser.mjs";
import { buildSite } from "../build.mjs";
import { main, root } from "../run.mjs";
import { setup } from "../setup.mjs";
import { app } from "./app.mjs";
import { generate } from "./clips.mjs";
import { core } from "./core.mjs";
import { native } from "./native.mjs";
import { references } from "./references.mjs";
import { figures, report } from "./report.mjs";

await main(async () => {
  await setup();
  await buildSite();
  const { chromium: executablePath } = await browser();
  await generate();
  const { chromium } = await import("playwright");
  const launch = () => chromium.launch({ executablePath, args: ["--no-sandbox"] });
  const inPage = await core(launch);
  const measured = {
    core: inPage,
    references: references(inPage.toes),
    native: await native(),
    app: await app(launch),
    sizes: sizes(),
  };
  figures(measured.core.growth);
  const text = report(measured);
  writeFileSync(join(root, "BENCHMARKS.md"), text);
  console.log(`\n${text}\nBENCHMARKS.md is written.`);
});

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
