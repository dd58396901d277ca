/** The way most people take, in Firefox as it is installed: nothing of it is made for tests. */

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

test.skip(!installed, "Firefox is not installed; FIREFOX_PATH says where, if it is elsewhere.");

/** What is saved stays in the page: where downloads go is the browser's business. */
declare global {
  var saved: Promise<string> | undefined;
}

interface There {
  page: Page;
  requests: string[];
  complaints: string[];
}

/** Opens an address in a browser of its own. */
async function visit(address: string, act: (there: There) => Promise<void>): Promise<void> {
  const browser = await puppeteer.launch({
    browser: "firefox",
    executablePath: installed ?? "",
    // Only with a display Firefox draws in 3D without a graphics card.
    headless: !process.env.DISPLAY,
    extraPrefsFirefox: { "webgl.force-enabled": true, "ui.prefersReducedMotion": 1 },
  });
  try {
    const page = await browser.newPage();
    await page.setViewport({ width: 1440, height: 900 });
    const there: There = { page, requests: [], complaints: [] };
    page.on("request", (request) => there.requests.push(request.url()));
    page.on("pageerror", (error) => there.complaints.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error") there.complaints.push(message.text());
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
        // A page without an address keeps nothing.
      }
    });
    await page.goto(address);
    await act(there);
    // Without WebGL the page says so itself, and so does three.js.
    const others = there.complaints.filter((complaint) => !/WebGL/.test(complaint));
    expect(others).toEqual([]);
  } finally {
    await browser.close();
  }
}

/** Clicks on what is called so. */
async function click(page: Page, role: "button" | "tab", name: string) {
  const found = await page.evaluateHandle(
    (selector, name) =>
      [...document.querySelectorAll<HTMLElement>(selector)].find((element) =>
        (element.getAttribute("aria-label") ?? element.textContent ?? "").trim().startsWith(name),
      ),
    role === "tab" ? "[role=tab]" : "button:not([role=tab])",
    name,
  );
  await (found.asElement() as ElementHandle<Element>).click();
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
    says: slider.getAttribute("aria-valuetext") ?? "",
  }));

async function chord(page: Page, held: KeyInput, key: KeyInput) {
  await page.keyboard.down(held);
  await page.keyboard.press(key);
  await page.keyboard.up(held);
}

/** Puts the playhead where the first plant begins or ends after the first frame. */
async function toFirstEdge(page: Page) {
  await page.keyboard.press("Home");
  expect((await playhead(page)).frame).toBe(0);
  await chord(page, "Shift", "ArrowRight");
}

/** The labels as they are saved. */
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

test("a file is opened, labelled, looked through, corrected and saved", async ({ app }) => {
  test.slow();
  await app.sample("bowling");
  const expected = (await app.save("Labels")).text;
  await visit(app.site.home, async ({ page, requests }) => {
    await page.waitForSelector("[data-state=empty]");
    const input = await page.$("input[type=file]");
    await input?.uploadFile(join(root, "samples/bowling.bvh"));
    await opened(page, "bowling.bvh");
    const before = requests.length;
    expect(JSON.parse(await labels(page))).toEqual(JSON.parse(expected));

    // From plant to plant by the keyboard, and through time.
    await page.locator("canvas").click();
    await toFirstEdge(page);
    const edge = await playhead(page);
    expect(edge.frame).toBeGreaterThan(0);
    expect(edge.says).toMatch(/planted/);
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

    // A plant is deleted and brought back.
    await toFirstEdge(page);
    await page.keyboard.press("e");
    await page.keyboard.press("Delete");
    expect(await labels(page)).not.toBe(expected);
    await chord(page, "Control", "z");
    expect(JSON.parse(await labels(page))).toEqual(JSON.parse(expected));
    for (const tab of ["Segment", "Clip", "Detect", "Evidence"]) {
      await click(page, "tab", tab);
      await page.waitForSelector(`[role=tabpanel]`);
    }
    writeFileSync(test.info().outputPath("firefox.png"), await page.screenshot());
    expect(requests.slice(before).filter((url) => !/^(blob|data):/.test(url))).toEqual([]);
  });
});

test("a page in one file opens from disk, with no request at all", async ({ app }, info) => {
  test.slow();
  await app.sample("bowling");
  const expected = (await app.save("Labels")).text;
  const file = info.outputPath("shared.html");
  writeFileSync(file, (await app.sharePage()).bytes);
  await visit(pathToFileURL(file).href, async ({ page, requests }) => {
    await opened(page, "bowling.bvh");
    expect(await labels(page)).toBe(expected);
    expect(requests.filter((url) => !/^(blob|data|file):/.test(url))).toEqual([]);
  });
});
