/** `node scripts/icons.mjs`: draws the icons of the installed app from web/public/icon.svg. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { chromium as playwright } from "playwright";
import { browser } from "./browser.mjs";
import { root } from "./run.mjs";

const folder = join(root, "web/public");
const drawing = readFileSync(join(folder, "icon.svg"), "utf8");

/** Name, pixels, the share of them that the drawing takes, and the ground behind it. */
const icons = [
  ["icon-192.png", 192, 0.9, "transparent"],
  ["icon-512.png", 512, 0.9, "transparent"],
  // Systems cut it to shapes of their own: what matters stays in the middle.
  ["icon-maskable.png", 512, 0.56, "#0f1317"],
];

const { chromium: executablePath } = await browser();
const held = await playwright.launch({ executablePath, args: ["--no-sandbox"] });
for (const [name, size, share, ground] of icons) {
  const page = await held.newPage({ viewport: { width: size, height: size } });
  await page.setContent(
    `<style>body{margin:0;height:100vh;display:grid;place-items:center;background:${ground}}
     svg{width:${100 * share}vw;height:${100 * share}vh}</style>${drawing}`,
  );
  await page.screenshot({ path: join(folder, name), omitBackground: true });
}
await held.close();
