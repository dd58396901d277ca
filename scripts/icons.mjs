/** `node scripts/icons.mjs`: draws the icons of the installed app from web/public/icon.svg. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { chromium as playwright } from "playwright";
import { browser } from "./browser.mjs";
import { root } from "./run.mjs";

const folder = join(root, "web/public");
const drawing = readFileSync(join(folder, "icon.svg"), "utf8");

/** File name, size in pixels, fraction of it that the drawing fills, and background. */
const icons = [
  ["icon-192.png", 192, 0.9, "transparent"],
  ["icon-512.png", 512, 0.9, "transparent"],
  // Systems crop maskable icons; the drawing stays inside the safe zone.
  ["icon-maskable.png", 512, 0.56, "#0f1317"],
];

const { chromium: executablePath } = await browser();
const chromium = await playwright.launch({ executablePath, args: ["--no-sandbox"] });
for (const [name, size, fraction, background] of icons) {
  const page = await chromium.newPage({ viewport: { width: size, height: size } });
  await page.setContent(
    `<style>body{margin:0;height:100vh;display:grid;place-items:center;background:${background}}
     svg{width:${100 * fraction}vw;height:${100 * fraction}vh}</style>${drawing}`,
  );
  await page.screenshot({ path: join(folder, name), omitBackground: true });
}
await chromium.close();
