/** The main workflow in an installed Firefox without test instrumentation. */

import { existsSync, writeFileSync } from "node:fs";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";
import puppeteer, { type ElementHandle, type KeyInput, type Page } from "puppeteer-core";
import { expect, test } from "./app";
import { root } from "./clips";

const names = ["firefox", "firefox-esr", "firefox.exe"];
const folders = [
  ...(process.env.PATH ?? "").split(delimiter),
  "/Applications/Firefox.app/Contents/MacOS",
  "C:\\Program Files\\Mozilla Firefox",
];
const installed =
  process.env.FIREFOX_PATH ??
  folders.flatMap((folder) => names.map((name) => join(folder, name))).find(existsSync);

test.skip(!installed, "Firefox was not found. Set FIREFOX_PATH to its path.");

/** Content of the last download, captured in the page. */
declare global {
  var saved: Promise<string> | undefined;
}

interface Visit {
  page: Page;
  requests: string[];
  problems: string[];
}

/** Opens a URL in a new browser and runs an action there. */
async function visit(url: string, action: (visit: Visit) => Promise<void>): Promise<void> {
  const browser = await puppeteer.launch({
    browser: "firefox",
    executablePath: installed ?? "",
    // Headless Firefox has no WebGL without a graphics card.
    headless: !process.env.DISPLAY,
    extraPrefsFirefox: { "webgl.force-enabled": true, "ui.prefersReducedMotion": 1 },
  });
  try {
    const page = await browser.newPage();
    await page.setViewport({ width: 1440, height: 900 });
    const current: Visit = { page, requests: [], problems: [] };
    page.on("request", (request) => current.requests.push(request.url()));
    page.on("pageerror", (error) => current.problems.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error") current.problems.push(message.text());
    });
    await page.evaluateOnNewDocument(() => {
      const create = URL.createObjectURL.bind(URL);
      URL.createObjectURL = (object) => {
        if (object instanceof Blob) globalThis.saved = object.text();
        return create(object);
      };
    });
    await page.evaluateOnNewDocument(() => {
      try {
        localStorage.setItem("plantigrade:tour", "done");
      } catch {
        // Pages without an origin have no storage.
      }
    });
    await page.goto(url);
    await action(current);
    // The page and three.js report missing WebGL.
    expect(current.problems.filter((problem) => !/WebGL/.test(problem))).toEqual([]);
  } finally {
    await browser.close();
  }
}

/** Clicks the first control whose name starts with `name`. */
async function click(page: Page, role: "button" | "tab", name: string) {
  const element = await page.evaluateHandle(
    (selector, name) =>
      [...document.querySelectorAll<HTMLElement>(selector)].find((element) =>
        (element.getAttribute("aria-label") ?? element.textContent ?? "").trim().startsWith(name),
      ),
    role === "tab" ? "[role=tab]" : "button:not([role=tab])",
    name,
  );
  await (element.asElement() as ElementHandle<Element>).click();
}

async function opened(page: Page, name: string) {
  await page.waitForFunction(
    (title) => document.title === title && document.querySelector("[data-state=ready] .pills"),
    {},
    `${name} – Plantigrade`,
  );
}

const playhead = (page: Page) =>
  page.$eval("[role=slider][aria-label=Playhead]", (slider) => ({
    frame: Number(slider.getAttribute("aria-valuenow")),
    text: slider.getAttribute("aria-valuetext") ?? "",
  }));

async function pressWith(page: Page, modifier: KeyInput, key: KeyInput) {
  await page.keyboard.down(modifier);
  await page.keyboard.press(key);
  await page.keyboard.up(modifier);
}

/** Moves the playhead to the first plant edge after the first frame. */
async function toFirstEdge(page: Page) {
  await page.keyboard.press("Home");
  expect((await playhead(page)).frame).toBe(0);
  await pressWith(page, "Shift", "ArrowRight");
}

/** Returns the saved labels. */
async function labels(page: Page): Promise<string> {
  await click(page, "tab", "Labels");
  if (!(await page.$("[role=tabpanel] [aria-expanded=true]"))) await click(page, "button", "Save");
  await page.evaluate(() => {
    globalThis.saved = undefined;
  });
  await click(page, "button", "Labels");
  await page.waitForFunction(() => globalThis.saved !== undefined);
  return page.evaluate(async () => (await globalThis.saved) ?? "");
}

test("opens, labels, plays, edits and saves a clip", async ({ app }) => {
  test.slow();
  await app.openSample("bowling");
  const expected = (await app.save("Labels")).text;
  await visit(app.site.home, async ({ page, requests }) => {
    await page.waitForSelector("[data-state=empty]");
    const input = await page.$("input[type=file]");
    await input?.uploadFile(join(root, "samples/bowling.bvh"));
    await opened(page, "bowling.bvh");
    const before = requests.length;
    expect(JSON.parse(await labels(page))).toEqual(JSON.parse(expected));

    // Steps to a plant edge by key, and plays.
    await page.locator("canvas").click();
    await toFirstEdge(page);
    const edge = await playhead(page);
    expect(edge.frame).toBeGreaterThan(0);
    expect(edge.text).toMatch(/in contact/);
    await page.keyboard.press("Home");
    await page.keyboard.press(" ");
    await page.waitForFunction(
      (frame) =>
        Number(document.querySelector("[aria-label=Playhead]")?.getAttribute("aria-valuenow")) >
        frame,
      {},
      20,
    );
    await page.keyboard.press(" ");

    // Deletes a plant and undoes that.
    await toFirstEdge(page);
    await page.keyboard.press("e");
    await page.keyboard.press("Delete");
    expect(await labels(page)).not.toBe(expected);
    await pressWith(page, "Control", "z");
    expect(JSON.parse(await labels(page))).toEqual(JSON.parse(expected));
    for (const tab of ["Segment", "Clip", "Detect", "Evidence"]) {
      await click(page, "tab", tab);
      await page.waitForSelector(`[role=tabpanel]`);
    }
    writeFileSync(test.info().outputPath("firefox.png"), await page.screenshot());
    expect(requests.slice(before).filter((url) => !/^(blob|data):/.test(url))).toEqual([]);
  });
});

test("opens a single-file page from disk without requests", async ({ app }, info) => {
  test.slow();
  await app.openSample("bowling");
  const expected = (await app.save("Labels")).text;
  const file = info.outputPath("shared.html");
  writeFileSync(file, (await app.savePage()).bytes);
  await visit(pathToFileURL(file).href, async ({ page, requests }) => {
    await opened(page, "bowling.bvh");
    expect(await labels(page)).toBe(expected);
    expect(requests.filter((url) => !/^(blob|data|file):/.test(url))).toEqual([]);
  });
});
