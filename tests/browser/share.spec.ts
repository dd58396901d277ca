import { writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import type { Browser, TestInfo } from "@playwright/test";
import { App, expect, type Saved, test } from "./app";
import { file, good, repeated, sample } from "./clips";

/** All that a link has to bring back. */
async function stateOf(app: App) {
  const link = await app.link();
  const labels = (await app.save("Frames")).text;
  const segments = (await app.saveSegments("Table")).text;
  return { link, labels, segments, frame: await app.frame() };
}

test("a link brings back moment, view, method and settings", async ({ app, page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await app.sample("curved-walk");
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

  await app.share();
  await app.dialog.getByRole("button", { name: "Copy" }).click();
  await expect(app.dialog.getByRole("button", { name: "Copied" })).toBeVisible();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toBe(before.link);

  const other = new App(await context.newPage(), app.site);
  await other.page.goto(copied);
  await other.opened("curved-walk.bvh");
  await expect(other.view.getByRole("button", { name: "Side" })).toHaveAttribute(
    "aria-pressed",
    "true",
  );
  expect(await stateOf(other)).toEqual(before);
  expect(other.complaints()).toEqual([]);
});

test("a link brings back where the camera was dragged, and how the file is read", async ({
  app,
  page,
  context,
}) => {
  const url = `${app.site.origin}/clips/limp-to-run.bvh`;
  await page.goto(`${app.site.home}#url=${url}`);
  await app.opened("limp-to-run.bvh");
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
  await other.opened("limp-to-run.bvh");
  expect(await stateOf(other)).toEqual(before);
});

test("nothing but the sample stands in a link to what is as usual", async ({ app, page }) => {
  await app.sample("skipping");
  expect(await app.link()).toBe(`${app.site.home}#sample=skipping`);
  await page.keyboard.press("ArrowRight");
  expect(await app.link()).toMatch(/#sample=skipping&t=[\d.]+$/);
});

test("what a link says wrongly is left out, and told", async ({ app, page }) => {
  await page.goto(
    `${app.site.home}#sample=bowling&t=2&method=magic&r=%3Cimg%20src=x%20onerror=alert(1)%3E&w=2`,
  );
  await app.opened("bowling.bvh");
  await expect(app.remark).toContainText(
    "The link contains “method=magic”, “r=<img src=x onerror=alert(1)>”, which is invalid",
  );
  expect(await app.frame()).toBe(60);
  await app.tab("Detect");
  await expect(page.getByRole("combobox", { name: "Method" })).toHaveValue("robust");
  await expect(app.panel).toContainText("± 2 frames");
  await app.remark.getByRole("button", { name: "Dismiss" }).click();
  await expect(app.remark).toHaveCount(0);
});

test("no link is given to a file of one's own", async ({ app, page }) => {
  await app.with(good("plain"));
  await app.head.getByRole("button", { name: "Share" }).focus();
  await page.keyboard.press("Enter");
  await expect(app.dialog).toContainText("There is no link to a local file");
  await expect(app.dialog.getByRole("textbox")).toHaveCount(0);
  await page.keyboard.press("Escape");
  await expect(app.dialog).toHaveCount(0);
  await expect(app.head.getByRole("button", { name: "Share" })).toBeFocused();
});

test("the view is saved as a picture", async ({ app }) => {
  await app.sample("ballet");
  await app.pressRuler(0.5);
  await app.share();
  const { name, bytes } = await app.download(() =>
    app.dialog.getByRole("button", { name: "Save picture" }).click(),
  );
  expect(name).toBe(`ballet-${await app.frame()}.png`);
  expect([...bytes.subarray(0, 4)]).toEqual([0x89, 0x50, 0x4e, 0x47]);
  // A picture of nothing is a few kB.
  expect(bytes.length).toBeGreaterThan(20_000);
});

/** A page in one file as someone has it who has nothing else: from disk, without a network. */
async function openPage(browser: Browser, { name, bytes }: Saved, info: TestInfo) {
  const path = info.outputPath(name);
  writeFileSync(path, bytes);
  const context = await browser.newContext({
    offline: true,
    reducedMotion: "reduce",
    viewport: { width: 1440, height: 900 },
  });
  const home = pathToFileURL(path).href;
  const asked: string[] = [];
  context.on("request", (request) => asked.push(request.url()));
  const app = new App(await context.newPage(), {
    origin: "null",
    home,
    close: () => context.close(),
  });
  await app.page.goto(home);
  const elsewhere = () => asked.filter((url) => url !== home && !/^(blob|data):/.test(url));
  return { app, context, elsewhere };
}

/** Nothing was asked for but the file itself, and the browser has nothing to complain of. */
const expectSound = ({ app, elsewhere }: { app: App; elsewhere: () => string[] }) => {
  expect(elsewhere()).toEqual([]);
  expect(
    app.complaints().filter((said) => !said.startsWith("request to elsewhere: file:")),
  ).toEqual([]);
};

test("a page in one file shows the clip from disk, with labels, corrections and names", async ({
  app,
  page,
  browser,
}, info) => {
  await app.with(sample("limp-to-run"));
  await app.tab("Detect");
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("0.7");
  await app.tab("Labels");
  await app.panel.getByRole("button", { name: /^3\s*(Left|Right)/ }).click();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("k");
  await app.tab("Segment");
  await app.panel
    .getByRole("textbox", { name: "Name of segment 2" })
    .fill("</script><b>turn & run");
  await page.keyboard.press("Enter");
  await app.pressRuler(0.45);
  const labels = await app.save("Labels");
  const segments = (await app.saveSegments("Table")).text;
  const saved = await app.sharePage();
  expect(saved.name).toBe("limp-to-run.html");
  info.annotations.push({ type: "size", description: `${saved.bytes.length} bytes` });

  const there = await openPage(browser, saved, info);
  await there.app.opened("limp-to-run.bvh");
  expect(await there.app.frame()).toBe(await app.frame());
  expect((await there.app.save("Labels")).text).toBe(labels.text);
  expect(labels.text).toContain('"edited"');
  expect((await there.app.saveSegments("Table")).text).toBe(segments);
  await expect(there.app.head).toContainText("Shared clip");
  await expect(there.app.head).toContainText("Made with Plantigrade");
  await there.app.timeline.getByRole("button", { name: "Play" }).click();
  const began = await there.app.frame();
  await expect.poll(() => there.app.frame()).toBeGreaterThan(began);
  expectSound(there);
  await there.context.close();
});

test("a page in one file is corrected, comes back so, and is shared again", async ({
  app,
  browser,
}, info) => {
  await app.sample("curved-walk");
  const there = await openPage(browser, await app.sharePage(), info);
  await there.app.opened("curved-walk.bvh");
  await there.app.page.keyboard.press("e");
  await there.app.page.keyboard.press("Delete");
  await there.app.tab("Labels");
  const undo = there.app.panel.getByRole("button", { name: "Undo" });
  await expect(undo).toBeEnabled();
  const corrected = (await there.app.save("Labels")).text;
  await there.app.page.reload();
  await there.app.opened("curved-walk.bvh");
  await expect.poll(async () => (await there.app.save("Labels")).text).toBe(corrected);

  const again = await there.app.sharePage();
  expectSound(there);
  await there.context.close();
  const third = await openPage(browser, { ...again, name: "again.html" }, info);
  await third.app.opened("curved-walk.bvh");
  await expect.poll(async () => (await third.app.save("Labels")).text).toBe(corrected);
  expectSound(third);
  await third.context.close();
});

test("a page in one file opens other clips, one and many", async ({ app, browser }, info) => {
  await app.sample("bowling");
  const there = await openPage(browser, await app.sharePage(), info);
  await there.app.opened("bowling.bvh");
  await there.app.drop(good("plain"));
  await there.app.opened("plain.bvh");
  await there.app.drop(sample("ballet"), sample("skipping"));
  await expect(there.app.page.getByText(/^All processed/)).toBeVisible();
  expectSound(there);
  await there.context.close();
});

test("no name gets out of its place in the page", async ({ app, browser }, info) => {
  const name = "<!--<script><img src=x onerror=alert(1)>.bvh";
  await app.empty();
  await app.drop(file(name, sample("bowling").buffer.toString()));
  await app.opened(name);
  await app.share();
  await expect(app.dialog.getByRole("heading", { name: `Share ${name}` })).toBeVisible();
  await app.page.keyboard.press("Escape");
  const saved = await app.sharePage();
  const there = await openPage(browser, { ...saved, name: "nasty.html" }, info);
  const alerts: string[] = [];
  there.app.page.on("dialog", (dialog) => {
    alerts.push(dialog.message());
    void dialog.dismiss();
  });
  await there.app.opened(name);
  expect(await there.app.page.locator("img").count()).toBe(0);
  expect(alerts).toEqual([]);
  expectSound(there);
  await there.context.close();
});

test("a page that takes long to make says how far it is, and can be stopped", async ({ app }) => {
  await app.with(repeated(sample("limp-to-run"), 100));
  await app.share();
  const save = app.dialog.getByRole("button", { name: "Save page" });
  await save.click();
  const bar = app.dialog.getByRole("progressbar", { name: /^Creating limp-to-run/ });
  await expect(bar).toBeVisible();
  expect(Number(await bar.getAttribute("value"))).toBeGreaterThan(0);
  // At once: by the time a mouse has got there it might be made.
  await app.dialog.getByRole("button", { name: "Cancel" }).dispatchEvent("click");
  await expect(bar).toBeHidden();
  await expect(save).toBeEnabled();
  await expect(app.alert).toBeHidden();
});
