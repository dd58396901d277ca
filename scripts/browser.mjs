/** The browser for tests: one that is there, or one that can be had. */

import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { delimiter, join } from "node:path";
import { ask, root, run, Stop, step } from "./run.mjs";

const BROWSERS = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const MAC = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";

/** Paths of Chromium and its driver; installs them where that can be done. */
export async function browser() {
  const missing = () => !chromium() || !driver();
  if (missing() && ask("apt-get", ["--version"]) !== undefined && process.getuid?.() === 0) {
    step("Installing Chromium for the tests");
    const source = "The Debian package server";
    await run("apt-get", ["update", "-qq"], { source, quiet: true });
    await run("apt-get", ["install", "-y", "-qq", "chromium", "chromium-driver"], {
      source,
      quiet: true,
    });
  }
  if (!chromium()) {
    step("Installing Chromium for the tests");
    await run(
      process.execPath,
      [join(root, "node_modules/playwright/cli.js"), "install", "chromium"],
      {
        source: "Playwright's server",
        hint: "Install Chromium or Chrome, or name it with CHROMIUM_PATH.",
      },
    );
  }
  if (!driver()) {
    throw new Stop(
      "The tests need ChromeDriver of the browser's version: install chromium-driver (Debian), chromedriver (npm, Homebrew), or name it with CHROMEDRIVER.",
    );
  }
  return { chromium: chromium(), driver: driver() };
}

function chromium() {
  const named = process.env.CHROMIUM_PATH;
  if (named && !existsSync(named))
    throw new Stop(`CHROMIUM_PATH names ${named}, which is not there.`);
  return named || onPath(BROWSERS) || [MAC, playwrights()].find((path) => path && existsSync(path));
}

/** The browser that Playwright has downloaded, if it has. */
function playwrights() {
  const { chromium } = createRequire(import.meta.url)("playwright");
  return chromium.executablePath();
}

function driver() {
  return process.env.CHROMEDRIVER ?? onPath(["chromedriver"]);
}

function onPath(names) {
  const folders = (process.env.PATH ?? "").split(delimiter);
  return names
    .flatMap((name) => folders.map((folder) => join(folder, name)))
    .find((path) => existsSync(path));
}
