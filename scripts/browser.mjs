/** Finds a browser for the tests, or installs one. */

import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { delimiter, join } from "node:path";
import { ask, root, run, Stop, step } from "./run.mjs";

const BROWSERS = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const SHELL = "chromium-headless-shell";
const FIREFOX = ["firefox", "firefox-esr"];
const MAC_CHROME = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";

/**
 * Returns the paths of Chromium, of ChromeDriver, and of the headless shell of Chromium; installs them if possible.
 * The shell has no user interface and therefore opens a page with 40 % less processor time; if it is missing,
 * its path is that of Chromium. Firefox is installed likewise; its tests are skipped if that is not possible.
 */
export async function browser() {
  const isMissing = !chromium() || !driver();
  const hasApt = ask("apt-get", ["--version"]) !== undefined && process.getuid?.() === 0;
  if (hasApt && (isMissing || !headlessShell() || !firefox())) {
    step("Installing Chromium and Firefox for the tests");
    const source = "The Debian package server";
    const install = (...names) =>
      run("apt-get", ["install", "-y", "-qq", ...names], { source, quiet: true });
    const updating = run("apt-get", ["update", "-qq"], { source, quiet: true });
    await (isMissing ? updating : updating.catch(ignoreStop));
    if (isMissing) await install("chromium", "chromium-driver");
    for (const name of [SHELL, "firefox-esr"]) {
      if (ask("apt-cache", ["show", name])) await install(name).catch(ignoreStop);
    }
  }
  if (!chromium()) {
    step("Installing Chromium for the tests");
    await run(
      process.execPath,
      [join(root, "node_modules/playwright/cli.js"), "install", "chromium"],
      {
        source: "Playwright's server",
        hint: "Install Chromium or Chrome, or set CHROMIUM_PATH to its path.",
      },
    );
  }
  if (!driver()) {
    throw new Stop(
      "ChromeDriver was not found. Install the version of your browser (chromium-driver on Debian, chromedriver from npm or Homebrew), or set CHROMEDRIVER to its path.",
    );
  }
  return { chromium: chromium(), headlessShell: headlessShell() ?? chromium(), driver: driver() };
}

/** Without the shell the tests are slower, and without Firefox some are skipped. */
function ignoreStop(error) {
  if (!(error instanceof Stop)) throw error;
}

function chromium() {
  const path = process.env.CHROMIUM_PATH;
  if (path && !existsSync(path)) throw new Stop(`CHROMIUM_PATH is ${path}, which does not exist.`);
  return (
    path ||
    onPath(BROWSERS) ||
    [MAC_CHROME, playwrightChromium()].find((candidate) => candidate && existsSync(candidate))
  );
}

function firefox() {
  return process.env.FIREFOX_PATH ?? onPath(FIREFOX);
}

function headlessShell() {
  return process.env.CHROMIUM_PATH ? chromium() : onPath([SHELL]);
}

/** Returns the path at which Playwright installs Chromium. */
function playwrightChromium() {
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
