import { writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import type { Browser, TestInfo } from "@playwright/test";
import { App, expect, type SavedFile, test } from "./app";
import { file, good, repeated, sample } from "./clips";

/** Returns everything that a link must restore. */
async function stateOf(app: App) {
  const link = await app.link();
  const labels = (await app.save("Every frame")).text;
  const segments = (await app.saveSegments("Table")).text;
  return { link, labels, segments, frame: await app.frame() };
}

test("restores time, view, method and settings from a link", async ({ app, page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await app.openSample("curved-walk");
  await app.tab("Detect");
  await page.getByRole("combobox", { name: "Method" }).selectOption("paper");
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("0.8");
  await app.tab("Segment");
  await page.getByRole("combobox", { name: "Method" }).selectOption("lsd");
  await app.pressRuler(0.4);
  await app.view.getByRole("button", { name: "Side" }).click();
  const before = await stateOf(app);
  expect(before.link).toMatch(
    /#sample=curved-walk&t=[\d.]+&method=paper&r=0\.\d+&segment=lsd&view=side$/,
  );

  await app.openShareDialog();
  await app.dialog.getByRole("button", { name: "Copy" }).click();
  await expect(app.dialog.getByRole("button", { name: "Copied" })).toBeVisible();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toBe(before.link);

  const other = new App(await context.newPage(), app.site);
  await other.page.goto(copied);
  await other.waitForClip("curved-walk.bvh");
  await expect(other.view.getByRole("button", { name: "Side" })).toHaveAttribute(
    "aria-pressed",
    "true",
  );
  expect(await stateOf(other)).toEqual(before);
  expect(other.unexpectedProblems()).toEqual([]);
});

test("states that a link carries neither edits nor names", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const notice = app.dialog.getByText("Edits and segment names are not included");
  await app.openShareDialog();
  await expect(notice).toBeHidden();
  await page.keyboard.press("Escape");
  await app.playhead.focus();
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await app.openShareDialog();
  await expect(notice).toBeVisible();
});

test("restores camera pose and overrides from a link", async ({ app, page, context }) => {
  const url = `${app.site.origin}/clips/limp-to-run.bvh`;
  await page.goto(`${app.site.home}#url=${url}`);
  await app.waitForClip("limp-to-run.bvh");
  await app.tab("Clip");
  await page.getByRole("spinbutton", { name: "Rate" }).fill("60");
  await page.keyboard.press("Enter");
  await expect(app.fact("Rate")).toHaveText("60 Hz");
  await app.pressRuler(0.7);
  const box = await app.stage.boundingBox();
  if (!box) throw new Error("There is no picture.");
  await page.mouse.move(box.x + 400, box.y + 300);
  await page.mouse.down();
  await page.mouse.move(box.x + 480, box.y + 330, { steps: 4 });
  await page.mouse.up();
  await app.stillPicture();
  const before = await stateOf(app);
  expect(before.link).toMatch(/#t=[\d.]+&rate=60&eye=[-\d.,]+&at=[-\d.,]+&url=http.*limp-to-run/);

  const other = new App(await context.newPage(), app.site);
  await other.page.goto(before.link);
  await other.waitForClip("limp-to-run.bvh");
  expect(await stateOf(other)).toEqual(before);
});

test("omits default values from links", async ({ app, page }) => {
  await app.openSample("skipping");
  expect(await app.link()).toBe(`${app.site.home}#sample=skipping`);
  await page.keyboard.press("ArrowRight");
  expect(await app.link()).toMatch(/#sample=skipping&t=[\d.]+$/);
});

test("ignores and reports invalid parts of a link", async ({ app, page }) => {
  await page.goto(
    `${app.site.home}#sample=bowling&t=2&method=magic&r=%3Cimg%20src=x%20onerror=alert(1)%3E&w=2`,
  );
  await app.waitForClip("bowling.bvh");
  await expect(app.toast).toContainText(
    "The link contains “method=magic”, “r=<img src=x onerror=alert(1)>”, which is invalid",
  );
  expect(await app.frame()).toBe(60);
  await app.tab("Detect");
  await expect(page.getByRole("combobox", { name: "Method" })).toHaveValue("robust");
  await expect(app.panel).toContainText("± 2 frames");
  await app.toast.getByRole("button", { name: "Dismiss" }).click();
  await expect(app.toast).toHaveCount(0);
});

test("offers no link for a local file", async ({ app, page }) => {
  await app.openFile(good("plain"));
  await app.head.getByRole("button", { name: "Share" }).focus();
  await page.keyboard.press("Enter");
  await expect(app.dialog).toContainText("Links work for samples and URLs only");
  await expect(app.dialog.getByRole("textbox")).toHaveCount(0);
  await page.keyboard.press("Escape");
  await expect(app.dialog).toHaveCount(0);
  await expect(app.head.getByRole("button", { name: "Share" })).toBeFocused();
});

test("saves the view as a picture", async ({ app }) => {
  await app.openSample("ballet");
  await app.pressRuler(0.5);
  await app.openShareDialog();
  const { name, bytes } = await app.download(() =>
    app.dialog.getByRole("button", { name: "Save picture" }).click(),
  );
  expect(name).toBe(`ballet-${await app.frame()}.png`);
  expect([...bytes.subarray(0, 4)]).toEqual([0x89, 0x50, 0x4e, 0x47]);
  // An empty picture has a few kB.
  expect(bytes.length).toBeGreaterThan(20_000);
});

/** Opens a single-file page from disk in an offline browser. */
async function openPage(browser: Browser, { name, bytes }: SavedFile, info: TestInfo) {
  const path = info.outputPath(name);
  writeFileSync(path, bytes);
  const context = await browser.newContext({
    offline: true,
    reducedMotion: "reduce",
    viewport: { width: 1440, height: 900 },
  });
  const home = pathToFileURL(path).href;
  const requested: string[] = [];
  context.on("request", (request) => requested.push(request.url()));
  const app = new App(await context.newPage(), {
    origin: "null",
    home,
    close: () => context.close(),
  });
  await app.page.goto(home);
  const otherRequests = () => requested.filter((url) => url !== home && !/^(blob|data):/.test(url));
  return { app, context, otherRequests };
}

/** Fails if the page requested anything but itself, or if there were unexpected problems. */
const expectNoRequests = ({ app, otherRequests }: { app: App; otherRequests: () => string[] }) => {
  expect(otherRequests()).toEqual([]);
  expect(
    app
      .unexpectedProblems()
      .filter((problem) => !problem.startsWith("request to elsewhere: file:")),
  ).toEqual([]);
};

test("a single-file page contains clip, labels, edits and names", async ({
  app,
  page,
  browser,
}, info) => {
  await app.openFile(sample("limp-to-run"));
  await app.tab("Detect");
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("0.7");
  await app.tab("Labels");
  await app.panel.getByRole("button", { name: /^3\s*(Left|Right)/ }).click();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("b");
  await app.tab("Segment");
  await app.panel
    .getByRole("textbox", { name: "Name of segment 2" })
    .fill("</script><b>turn & run");
  await page.keyboard.press("Enter");
  await app.pressRuler(0.45);
  const labels = await app.save("Labels");
  const segments = (await app.saveSegments("Table")).text;
  const saved = await app.savePage();
  expect(saved.name).toBe("limp-to-run.html");
  info.annotations.push({ type: "size", description: `${saved.bytes.length} bytes` });

  const shared = await openPage(browser, saved, info);
  await shared.app.waitForClip("limp-to-run.bvh");
  expect(await shared.app.frame()).toBe(await app.frame());
  expect((await shared.app.save("Labels")).text).toBe(labels.text);
  expect(labels.text).toContain('"edited"');
  expect((await shared.app.saveSegments("Table")).text).toBe(segments);
  await expect(shared.app.head).toContainText("Shared clip");
  await expect(shared.app.head).toContainText("Made with Plantigrade");
  await expect(shared.app.page.getByRole("complementary", { name: "Tour" })).toBeHidden();
  await shared.app.timeline.getByRole("button", { name: "Play" }).click();
  const start = await shared.app.frame();
  await expect.poll(() => shared.app.frame()).toBeGreaterThan(start);
  expectNoRequests(shared);
  await shared.context.close();
});

test("a single-file page stores edits and can be shared again", async ({ app, browser }, info) => {
  await app.openSample("curved-walk");
  const shared = await openPage(browser, await app.savePage(), info);
  await shared.app.waitForClip("curved-walk.bvh");
  await shared.app.page.keyboard.press("e");
  await shared.app.page.keyboard.press("Delete");
  await shared.app.tab("Labels");
  const undo = shared.app.panel.getByRole("button", { name: "Undo" });
  await expect(undo).toBeEnabled();
  const corrected = (await shared.app.save("Labels")).text;
  await shared.app.page.reload();
  await shared.app.waitForClip("curved-walk.bvh");
  await expect.poll(async () => (await shared.app.save("Labels")).text).toBe(corrected);

  const again = await shared.app.savePage();
  expectNoRequests(shared);
  await shared.context.close();
  const third = await openPage(browser, { ...again, name: "again.html" }, info);
  await third.app.waitForClip("curved-walk.bvh");
  await expect.poll(async () => (await third.app.save("Labels")).text).toBe(corrected);
  expectNoRequests(third);
  await third.context.close();
});

test("a single-file page opens other clips", async ({ app, browser }, info) => {
  await app.openSample("bowling");
  const shared = await openPage(browser, await app.savePage(), info);
  await shared.app.waitForClip("bowling.bvh");
  await shared.app.drop(good("plain"));
  await shared.app.waitForClip("plain.bvh");
  await shared.app.drop(sample("ballet"), sample("skipping"));
  await expect(shared.app.page.getByText(/^All processed/)).toBeVisible();
  expectNoRequests(shared);
  await shared.context.close();
});

test("escapes file names in a single-file page", async ({ app, browser }, info) => {
  const name = "<!--<script><img src=x onerror=alert(1)>.bvh";
  await app.openStartPage();
  await app.drop(file(name, sample("bowling").buffer.toString()));
  await app.waitForClip(name);
  await app.openShareDialog();
  await expect(app.dialog.getByRole("heading", { name: `Share ${name}` })).toBeVisible();
  await app.page.keyboard.press("Escape");
  const saved = await app.savePage();
  const shared = await openPage(browser, { ...saved, name: "nasty.html" }, info);
  const alerts: string[] = [];
  shared.app.page.on("dialog", (dialog) => {
    alerts.push(dialog.message());
    void dialog.dismiss();
  });
  await shared.app.waitForClip(name);
  expect(await shared.app.page.locator("img").count()).toBe(0);
  expect(alerts).toEqual([]);
  expectNoRequests(shared);
  await shared.context.close();
});

test("reports progress of a page and can be cancelled", async ({ app }) => {
  await app.openFile(repeated(sample("limp-to-run"), 100));
  await app.openShareDialog();
  const save = app.dialog.getByRole("button", { name: "Save page" });
  await save.click();
  const bar = app.dialog.getByRole("progressbar", { name: /^Creating limp-to-run/ });
  await expect(bar).toBeVisible();
  expect(Number(await bar.getAttribute("value"))).toBeGreaterThan(0);
  // Dispatched directly, because the page might be finished before a mouse click.
  await app.dialog.getByRole("button", { name: "Cancel" }).dispatchEvent("click");
  await expect(bar).toBeHidden();
  await expect(save).toBeEnabled();
  await expect(app.alert).toBeHidden();
});
