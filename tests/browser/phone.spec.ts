import { type App, expect, test } from "./app";
import { clip, repeated, sample } from "./clips";
import { readLabels } from "./labels";

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

/** Nothing sticks out at the side. */
async function expectNoSideways(app: App) {
  const [inner, wide] = await app.page.evaluate(() => [
    document.documentElement.clientWidth,
    document.documentElement.scrollWidth,
  ]);
  expect(wide).toBe(inner);
}

test("a tap on a sample opens it on a phone", async ({ app, page }) => {
  await app.empty();
  await expect(page.getByRole("button", { name: "Open a file" })).toBeInViewport();
  await expectNoSideways(app);
  await page.getByRole("button", { name: "Frog jumps", exact: true }).tap();
  await app.opened("frog-jumps.bvh");
  await expectNoSideways(app);
  await expect(app.playhead).toBeInViewport();
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeInViewport({ ratio: 1 });
});

test("the frame and their number are whole on a phone", async ({ app, page }) => {
  await app.with(repeated(sample("frog-jumps"), 10));
  await page.keyboard.press("End");
  const frames = page.locator(".frame-count");
  await expect(frames).toContainText(/4.999 \/ 5.000/);
  const [inner = 0, wide = 1] = await frames.evaluate((it) => [it.clientWidth, it.scrollWidth]);
  expect(wide).toBeLessThanOrEqual(inner);
});

test("the panel rises and sinks on a phone", async ({ app, page }) => {
  await app.sample("frog-jumps");
  const r = page.getByRole("slider", { name: "Sensitivity r" });
  await expect(r).not.toBeInViewport();
  await page.getByRole("button", { name: "Expand panel" }).tap();
  await expect(r).toBeInViewport({ ratio: 1 });
  await expectNoSideways(app);
  await page.getByRole("button", { name: "Collapse panel" }).tap();
  await expect(r).not.toBeInViewport();
  await page.getByRole("tab", { name: "Labels" }).tap();
  const undo = page.getByRole("button", { name: "Undo" });
  await expect(undo).toBeInViewport({ ratio: 1 });
  await page.getByRole("tab", { name: "Labels" }).tap();
  await expect(undo).not.toBeInViewport();
});

test("what a thumb taps is at least 24 pixels high", async ({ app, page }) => {
  await app.sample("frog-jumps");
  // The table of plants is for screen readers: there is nothing of it to see.
  const buttons = await page.locator("button:not(table *):visible").all();
  expect(buttons.length).toBeGreaterThan(10);
  for (const button of buttons) {
    const { name, height } = await button.evaluate(hitHeight);
    expect(height, name).toBeGreaterThanOrEqual(24);
  }
});

/** How high a control is to the touch, which may be more than it looks. */
function hitHeight(element: Element) {
  const box = element.getBoundingClientRect();
  const x = box.x + box.width / 2;
  let height = 0;
  for (let y = box.y - 20; y < box.bottom + 20; y++) {
    if (element.contains(document.elementFromPoint(x, y))) height++;
  }
  return { name: element.getAttribute("aria-label") ?? element.textContent, height };
}

test("a long clip leaves the buttons of playback their room", async ({ app }) => {
  await app.with(repeated(sample("curved-walk"), 50));
  await app.page.keyboard.press("End");
  const box = await app.timeline.getByRole("button", { name: "Play" }).boundingBox();
  expect(box?.width).toBeGreaterThanOrEqual(44);
  await expectNoSideways(app);
});

test("the bars of the timeline can be hit by a thumb", async ({ app, page }) => {
  await app.sample("frog-jumps");
  const labels = readLabels(await app.save("Labels"));
  await page.getByRole("tab", { name: "Labels" }).tap();
  await page.keyboard.press("End");
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  // Down through a column where the toe stands, a tap on its bar goes to the bar's start.
  const long = labels.left.toe?.toSorted((a, b) => b.end - b.start - (a.end - a.start))[0];
  if (!long) throw new Error("The left toe never stands.");
  const first = await app.pressRuler(0.5);
  const second = await app.pressRuler(0.75);
  const perFrame = (0.25 * box.width) / (second - first);
  const x = box.x + 0.5 * box.width + ((long.start + long.end) / 2 - first) * perFrame;
  let hit = 0;
  for (let y = 30; y < 200; y += 2) {
    // In between somewhere else, or two taps would be a double one.
    await page.touchscreen.tap(box.x + 0.5 * box.width, box.y + 12);
    await page.touchscreen.tap(x, box.y + y);
    if ((await app.frame()) === long.start) hit += 2;
  }
  expect(hit).toBeGreaterThanOrEqual(28);
});

test("pills make room for the raised panel", async ({ app, page }) => {
  await app.sample("frog-jumps");
  const pill = app.view.getByText(/^Left (planted|in the air)/);
  await expect(pill).toBeInViewport({ ratio: 1 });
  await page.getByRole("button", { name: "Expand panel" }).tap();
  await expect(pill).toBeHidden();
  await page.getByRole("button", { name: "Collapse panel" }).tap();
  await expect(pill).toBeVisible();
});

test("a short phone still shows a picture worth the name", async ({ app, page }) => {
  await page.setViewportSize({ width: 375, height: 667 });
  await app.sample("ballet");
  const stage = await app.stage.boundingBox();
  const tools = await app.view.getByRole("button", { name: "Follow" }).boundingBox();
  const pill = await app.view.getByText(/^Left (planted|in the air)/).boundingBox();
  expect((pill?.y ?? 0) - ((tools?.y ?? 0) + (tools?.height ?? 0))).toBeGreaterThan(150);
  expect(stage?.height).toBeGreaterThan(230);
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeInViewport({ ratio: 1 });
  await expectNoSideways(app);
});

test("a comparison fits the timeline of a short phone", async ({ app, page }) => {
  await page.setViewportSize({ width: 375, height: 667 });
  await app.sample("frog-jumps");
  await app.drop(clip("samples/frog-jumps.json"));
  await expect(page.getByRole("tab", { name: "Score" })).toBeVisible();
  const room = app.tracks.locator("xpath=..");
  await expect
    .poll(async () => (await app.tracks.boundingBox())?.height)
    .toBeLessThanOrEqual((await room.boundingBox())?.height ?? 0);
});

test("a comparison fits a phone", async ({ app, page }) => {
  await app.sample("frog-jumps");
  await app.drop(clip("samples/frog-jumps.json"));
  await page.getByRole("button", { name: "Expand panel" }).tap();
  await expect(page.getByRole("tabpanel", { name: "Score" })).toBeVisible();
  await expectNoSideways(app);
  const open = page.getByRole("button", { name: "Open", exact: true });
  await expect(open).toBeInViewport({ ratio: 1 });
  await expect(app.panel.getByRole("row", { name: /^0\.3 s/ })).toBeInViewport({ ratio: 1 });
});

test("a tap loops a segment, and a second one asks for its name", async ({ app, page }) => {
  await app.sample("limp-to-run");
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const loop = app.timeline.getByText("Loop segment", { exact: false });
  const name = page.getByRole("textbox", { name: "Name of segment 2" });
  const tapRuler = () => page.touchscreen.tap(box.x + 0.75 * box.width, box.y + 8);
  let at = 0;
  let hit = 0;
  for (let y = box.height - 40; y > 200; y -= 2) {
    await page.touchscreen.tap(box.x + 0.75 * box.width, box.y + y);
    if (!(await loop.textContent({ timeout: 100 }).catch(() => ""))) continue;
    at ||= y;
    hit += 2;
    if (hit >= 24) break;
    // A tap on the ruler separates the taps on the segment, which are not double taps then.
    await tapRuler();
    await page.keyboard.press("Home");
    await page.keyboard.press("l");
  }
  expect(hit).toBeGreaterThanOrEqual(24);
  await tapRuler();
  for (let i = 0; i < 2; i++) await page.touchscreen.tap(box.x + 0.75 * box.width, box.y + at - 8);
  await expect(name).toBeFocused();
  await expect(name).toBeInViewport({ ratio: 1 });
  await expectNoSideways(app);
});

test("all six tabs fit a phone", async ({ app, page }) => {
  await app.sample("frog-jumps");
  await app.drop(clip("samples/frog-jumps.json"));
  for (const tab of await page.getByRole("tab").all()) {
    await expect(tab).toBeInViewport({ ratio: 1 });
  }
  await expect(page.getByRole("tab")).toHaveCount(6);
  await expectNoSideways(app);
});

test("the ways to share fit a phone", async ({ app, page }) => {
  await app.sample("frog-jumps");
  const share = app.head.getByRole("button", { name: "Share" });
  await expect(share).toBeInViewport({ ratio: 1 });
  await share.tap();
  await expect(app.dialog).toBeInViewport({ ratio: 1 });
  for (const name of ["Copy", "Save page", "Save picture", "Close"]) {
    const button = app.dialog.getByRole("button", { name });
    await expect(button).toBeInViewport({ ratio: 1 });
    expect((await button.boundingBox())?.height).toBeGreaterThanOrEqual(44);
  }
  await expectNoSideways(app);
  await page.setViewportSize({ width: 375, height: 667 });
  await expect(app.dialog).toBeInViewport({ ratio: 1 });
});
