/**
 * `node scripts/poster.mjs`: renders the still images that the start page shows until the 3D view is
 * ready, for wide and narrow pages in both themes. Build the site without the images first.
 */

import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { chromium as browserType } from "playwright";
import { preview } from "vite";
import { browser } from "./browser.mjs";
import { root } from "./run.mjs";

const folder = join(root, "web/src/styles/poster");
const sizes = { wide: { width: 1600, height: 900 }, narrow: { width: 480, height: 900 } };

const { chromium: executablePath } = await browser();
const site = await preview({ root: join(root, "web"), logLevel: "warn" });
const chromium = await browserType.launch({ executablePath, args: ["--no-sandbox"] });
mkdirSync(folder, { recursive: true });
for (const [layout, viewport] of Object.entries(sizes)) {
  for (const colorScheme of ["light", "dark"]) {
    const page = await chromium.newPage({
      viewport,
      colorScheme,
      reducedMotion: "reduce",
      bypassCSP: true,
    });
    await page.goto(site.resolvedUrls.local[0]);
    await page.mouse.move(2, 2);
    await page.locator(".stage canvas").waitFor();
    // Waits for the labels and the footprints.
    await page.waitForTimeout(5000);
    await page.addStyleTag({ content: "body :not(:has(.stage), .stage, .stage *) { opacity: 0 }" });
    const screenshot = await page.locator(".stage").screenshot();
    const webp = await page.evaluate(
      async (data) => {
        const bitmap = await createImageBitmap(await (await fetch(data)).blob());
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
        const blob = await canvas.convertToBlob({ type: "image/webp", quality: 0.7 });
        return Array.from(new Uint8Array(await blob.arrayBuffer()));
      },
      `data:image/png;base64,${screenshot.toString("base64")}`,
    );
    writeFileSync(join(folder, `${layout}-${colorScheme}.webp`), Buffer.from(webp));
    await page.close();
  }
}
await chromium.close();
await site.close();
