/** `npm run bench`: measures speed, memory and download size, and writes BENCHMARKS.md. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { browser } from "../browser.mjs";
import { buildSite } from "../build.mjs";
import { main, root } from "../run.mjs";
import { setup } from "../setup.mjs";
import { compareWith } from "./against.mjs";
import { appRows } from "./app.mjs";
import { generateClips } from "./clips.mjs";
import { detectionRows, growthRows, memoryRows, readingRows, segmentationRows } from "./core.mjs";
import { startNative } from "./native.mjs";
import { serveBenchPage } from "./page.mjs";
import { clusteringRows, packageRows } from "./references.mjs";
import { toMarkdown, writeCharts } from "./report.mjs";
import { sizeRows } from "./sizes.mjs";

await main(async () => {
  const { values } = parseArgs({ options: { against: { type: "string" } } });
  await setup();
  const { chromium: executablePath } = await browser();
  const { chromium } = await import("playwright");
  const launch = () => chromium.launch({ executablePath, args: ["--no-sandbox"] });
  await generateClips();
  if (values.against) return await compareWith(values.against, launch);
  await buildSite();
  const native = await startNative({ tree: root });
  const server = await serveBenchPage({ tree: root, launch });
  try {
    const where = { native, server, launch };
    const reading = await readingRows(where);
    const detection = await detectionRows(where);
    const segmentation = await segmentationRows(where);
    const long = await growthRows(where);
    const rows = [
      ...reading,
      ...(await memoryRows(where)),
      ...detection.rows,
      ...(await clusteringRows(detection)),
      ...segmentation,
      ...long.rows,
      ...(await appRows(where)),
      ...(await packageRows(where)),
      ...sizeRows(),
    ];
    writeCharts(long.growth);
    const markdown = toMarkdown({ rows, growth: long.growth });
    writeFileSync(join(root, "BENCHMARKS.md"), markdown);
    console.log(`\n${markdown}\nWrote BENCHMARKS.md.`);
  } finally {
    native.close();
    await server.close();
  }
});
