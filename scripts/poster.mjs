/**
 * `node scripts/poster.mjs`: renders the still images of the start page, for wide and narrow screens,
 * light and dark. Requires a site that was built without them.
 */

import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { chromium as playwright } from "playwright";
import { preview } from "vite";
import { browser } from "./browser.mjs";
import { root } from "./run.mjs";

const folder = join(root, "web/src/styles/poster");
const sizes = { wide: { width: 1600, height: 900 }, narrow: { width: 480, height: 900 } };

const { chromium: executablePath } = await browser();
const site = await preview({ root: join(root, "web"), logLevel: "warn" });
const chromium = await playwright.launch({ executablePath, args: ["--no-sandbox"] });
mkdirSync(folder, { recursive: true });
for (const [shape, viewport] of Object.entries(sizes)) {
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
    // Waits for the detection, after which footprints are drawn.
    await page.waitForTimeout(5000);
    await page.addStyleTag({ content: "body :not(:has(.stage), .stage, .stage *) { opacity: 0 }" });
    const screenshot = await page.locator(".stage").screenshot();
    const picture = await page.evaluate(
      async (data) => {
        const bitmap = await createImageBitmap(await (await fetch(data)).blob());
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
        const blob = await canvas.convertToBlob({ type: "image/webp", quality: 0.7 });
        return Array.from(new Uint8Array(await blob.arrayBuffer()));
      },
      `data:image/png;base64,${screenshot.toString("base64")}`,
    );
    writeFileSync(join(folder, `${shape}-${colorScheme}.webp`), Buffer.from(picture));
    await page.close();
  }
}
await chromium.close();
await site.close();
