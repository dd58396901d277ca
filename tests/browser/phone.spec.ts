import { type App, expect, test } from "./app";
import { bad, clip, repeated, sample } from "./clips";
import { readLabels } from "./labels";

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

/** Fails if the page scrolls horizontally. */
async function expectNoHorizontalScroll(app: App) {
  const [clientWidth, scrollWidth] = await app.page.evaluate(() => [
    document.documentElement.clientWidth,
    document.documentElement.scrollWidth,
  ]);
  expect(scrollWidth).toBe(clientWidth);
}

test("opens a sample by tap", async ({ app, page }) => {
  await app.openStartPage();
  await expect(page.getByRole("button", { name: "Open a file" })).toBeInViewport();
  await expectNoHorizontalScroll(app);
  await page.getByRole("button", { name: "Frog jumps", exact: true }).tap();
  await app.waitForClip("frog-jumps.bvh");
  await expectNoHorizontalScroll(app);
  await expect(app.playhead).toBeInViewport();
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeInViewport({ ratio: 1 });
});

test("shows the frame count without clipping", async ({ app, page }) => {
  await app.openFile(repeated(sample("frog-jumps"), 10));
  await page.keyboard.press("End");
  const frames = page.locator(".frame-count");
  await expect(frames).toContainText(/4.999 \/ 4.999/);
  const [clientWidth = 0, scrollWidth = 1] = await frames.evaluate((element) => [
    element.clientWidth,
    element.scrollWidth,
  ]);
  expect(scrollWidth).toBeLessThanOrEqual(clientWidth);
});

test("expands and collapses the panel", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  const r = page.getByRole("slider", { name: "Sensitivity r" });
  await expect(r).not.toBeInViewport();
  await page.getByRole("button", { name: "Expand panel" }).tap();
  await expect(r).toBeInViewport({ ratio: 1 });
  await expectNoHorizontalScroll(app);
  await page.getByRole("button", { name: "Collapse panel" }).tap();
  await expect(r).not.toBeInViewport();
  await page.getByRole("tab", { name: "Labels" }).tap();
  const undo = page.getByRole("button", { name: "Undo" });
  await expect(undo).toBeInViewport({ ratio: 1 });
  await page.getByRole("tab", { name: "Labels" }).tap();
  await expect(undo).not.toBeInViewport();
});

test("has touch targets of at least 24 pixels", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  // The tables for screen readers are not visible.
  const buttons = await page.locator("button:not(table *):visible").all();
  expect(buttons.length).toBeGreaterThan(10);
  for (const button of buttons) {
    const { name, height } = await button.evaluate(hitHeight);
    expect(height, name).toBeGreaterThanOrEqual(24);
  }
});

/** Returns the height of the area in which a control can be touched, in pixels. */
function hitHeight(element: Element) {
  const box = element.getBoundingClientRect();
  const x = box.x + box.width / 2;
  let height = 0;
  for (let y = box.y - 20; y < box.bottom + 20; y++) {
    if (element.contains(document.elementFromPoint(x, y))) height++;
  }
  return { name: element.getAttribute("aria-label") ?? element.textContent, height };
}

test("does not shrink the playback buttons for a long clip", async ({ app }) => {
  await app.openFile(repeated(sample("curved-walk"), 50));
  await app.page.keyboard.press("End");
  const box = await app.timeline.getByRole("button", { name: "Play" }).boundingBox();
  expect(box?.width).toBeGreaterThanOrEqual(44);
  await expectNoHorizontalScroll(app);
});

test("has timeline bars that are large enough for touch", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  const labels = readLabels(await app.save("Labels"));
  await page.getByRole("tab", { name: "Labels" }).tap();
  await page.keyboard.press("End");
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  // Taps down a column within a plant; a tap on its bar goes to the start of the plant.
  const long = labels.left.contact?.toSorted((a, b) => b.end - b.start - (a.end - a.start))[0];
  if (!long) throw new Error("The left foot is never planted.");
  const first = await app.pressRuler(0.5);
  const second = await app.pressRuler(0.75);
  const perFrame = (0.25 * box.width) / (second - first);
  const x = box.x + 0.5 * box.width + ((long.start + long.end) / 2 - first) * perFrame;
  let hit = 0;
  for (let y = 30; y < 200; y += 2) {
    // A tap elsewhere in between prevents double taps.
    await page.touchscreen.tap(box.x + 0.5 * box.width, box.y + 12);
    await page.touchscreen.tap(x, box.y + y);
    if ((await app.frame()) === long.start) hit += 2;
  }
  expect(hit).toBeGreaterThanOrEqual(28);
});

test("leaves the timeline visible while the panel is expanded", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  await page.getByRole("tab", { name: "Labels" }).tap();
  await expect(page.getByRole("button", { name: "Undo" })).toBeInViewport({ ratio: 1 });
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeInViewport({ ratio: 1 });
  await expect(app.view.getByText(/^Left in (contact|the air)/)).toBeInViewport({ ratio: 1 });
  const container = app.tracks.locator("xpath=..");
  await expect(container).toBeInViewport({ ratio: 1 });
  expect((await app.stage.boundingBox())?.height).toBeGreaterThanOrEqual(180);
  await expectNoHorizontalScroll(app);
  await test.step("explains how to show the tracks for which there is no space", async () => {
    await app.timeline.getByRole("button", { name: /^Tracks/ }).tap();
    const note = app.timeline.getByText(/^There is no space/);
    await expect.poll(() => note.innerText()).toMatch(/Hide other tracks, or lower the panel\.$/);
    await page.keyboard.press("Escape");
  });
});

test("has Open in the header, and Fit and the shortcuts at hand", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  for (const button of [
    app.head.getByRole("button", { name: "Open", exact: true }),
    app.head.getByRole("button", { name: "Keyboard shortcuts" }),
    app.timeline.getByRole("button", { name: "Fit" }),
  ]) {
    await expect(button).toBeInViewport({ ratio: 1 });
    expect((await button.boundingBox())?.height).toBeGreaterThanOrEqual(44);
  }
  await expect(page.getByRole("tablist").getByRole("button", { name: "Open" })).toHaveCount(0);
});

test("shares a clip of a batch", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(sample("bowling"), sample("frog-jumps"));
  await page.getByRole("button", { name: "bowling.bvh", exact: true }).tap();
  await app.waitForClip("bowling.bvh");
  const controls = [
    page.getByRole("button", { name: "2 clips" }),
    app.head.getByRole("checkbox", { name: "Checked" }),
    app.head.getByRole("button", { name: "Next" }),
    app.head.getByRole("button", { name: "Share" }),
  ];
  for (const control of controls) await expect(control).toBeInViewport({ ratio: 1 });
  await expectNoHorizontalScroll(app);
  await app.head.getByRole("button", { name: "Share" }).tap();
  await expect(app.dialog).toBeVisible();
});

test("marks edited plants and clips, and shows how many plants are to be reviewed", async ({
  app,
  page,
}) => {
  await app.openSample("curved-walk");
  await page.keyboard.press("e");
  await page.keyboard.press("w");
  await app.tab("Labels");
  const plant = app.panel.getByRole("listitem").filter({ hasText: "edited" });
  await plant.getByText("edited").scrollIntoViewIfNeeded();
  await expect(plant.getByText("edited")).toBeInViewport({ ratio: 1 });
  const clips = ["drunken-stagger", "straight-jog", "bowling", "curved-walk"];
  await app.drop(...clips.map(sample));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await expect(
    page
      .getByRole("row", { name: /curved-walk/ })
      .getByText("edited")
      .first(),
  ).toBeVisible();
  await expect(page.locator(".batch").getByText("edited").locator("visible=true")).toHaveCount(1);
  const cells = page.getByRole("cell", { name: / to review$/ });
  expect(await cells.count()).toBeGreaterThan(0);
  for (const cell of await cells.all()) {
    expect(await cell.evaluate((element) => element.scrollWidth - element.clientWidth)).toBe(0);
  }
});

test("shows clips of a batch side by side", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.drop(sample("drunken-stagger"), sample("straight-jog"), bad("empty"));
  await expect(page.getByText(/^All processed, 1 failed/)).toBeVisible();
  // The button that closes the table is in the first line, at the right edge.
  const close = await page.getByRole("button", { name: "Back to curved-walk.bvh" }).boundingBox();
  const filter = await page.getByRole("searchbox", { name: "Filter by name" }).boundingBox();
  expect((close?.y ?? 0) + (close?.height ?? 0)).toBeLessThanOrEqual(filter?.y ?? 0);
  expect((close?.x ?? 0) + (close?.width ?? 0)).toBeGreaterThan(370);
  for (const name of ["drunken-stagger.bvh", "straight-jog.bvh"]) {
    const button = page.getByRole("button", { name: `${name} side by side` });
    await expect(button).toBeInViewport({ ratio: 1 });
    await button.tap();
    await expect(button).toHaveAttribute("aria-pressed", "true");
  }
  await expectNoHorizontalScroll(app);
});

test("has a usable 3D view on a short screen", async ({ app, page }) => {
  await page.setViewportSize({ width: 375, height: 667 });
  await app.openSample("ballet");
  const stage = await app.stage.boundingBox();
  const tools = await app.view.getByRole("button", { name: "Follow" }).boundingBox();
  const pill = await app.view.getByText(/^Left in (contact|the air)/).boundingBox();
  expect((pill?.y ?? 0) - ((tools?.y ?? 0) + (tools?.height ?? 0))).toBeGreaterThan(150);
  expect(stage?.height).toBeGreaterThan(230);
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeInViewport({ ratio: 1 });
  await expectNoHorizontalScroll(app);
});

test("fits a comparison into the timeline of a short screen", async ({ app, page }) => {
  await page.setViewportSize({ width: 375, height: 667 });
  await app.openSample("frog-jumps");
  await app.drop(clip("samples/frog-jumps.json"));
  await expect(page.getByRole("tab", { name: "Score" })).toBeVisible();
  const container = app.tracks.locator("xpath=..");
  await expect
    .poll(async () => (await app.tracks.boundingBox())?.height)
    .toBeLessThanOrEqual((await container.boundingBox())?.height ?? 0);
});

test("fits the Score tab", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  await app.drop(clip("samples/frog-jumps.json"));
  await expect(page.getByRole("tabpanel", { name: "Score" })).toBeVisible();
  await expectNoHorizontalScroll(app);
  const open = page.getByRole("button", { name: "Open", exact: true });
  await expect(open).toBeInViewport({ ratio: 1 });
  await app.panel.getByRole("row", { name: /^0\.3 s/ }).scrollIntoViewIfNeeded();
  await expect(app.panel.getByRole("row", { name: /^0\.3 s/ })).toBeInViewport({ ratio: 1 });
});

test("loops a segment by tap and renames it by double tap", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const loop = app.timeline.getByText("Loop segment", { exact: false });
  const name = page.getByRole("textbox", { name: "Name of segment 2" });
  const tapRuler = () => page.touchscreen.tap(box.x + 0.75 * box.width, box.y + 8);
  // Two frames later, the page displays the effect of a tap.
  const nextFrames = () =>
    page.evaluate(
      () =>
        new Promise<void>((resolve) => {
          requestAnimationFrame(() => requestAnimationFrame(() => resolve()));
        }),
    );
  let at = 0;
  let hit = 0;
  for (let y = box.height - 40; y > 200; y -= 2) {
    await page.touchscreen.tap(box.x + 0.75 * box.width, box.y + y);
    await nextFrames();
    if ((await loop.count()) === 0) continue;
    at ||= y;
    hit += 2;
    if (hit >= 24) break;
    // A tap on the ruler separates the taps on the segment, which are not double taps then.
    await tapRuler();
    await page.keyboard.press("Home");
    await page.keyboard.press("Shift+l");
  }
  expect(hit).toBeGreaterThanOrEqual(24);
  await tapRuler();
  for (let i = 0; i < 2; i++) await page.touchscreen.tap(box.x + 0.75 * box.width, box.y + at - 8);
  await expect(name).toBeFocused();
  await expect(name).toBeInViewport({ ratio: 1 });
  await expectNoHorizontalScroll(app);
});

test("explains how the edges of a tapped bar are dragged", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const plant = readLabels(await app.save("Labels")).left.contact?.[1];
  if (!plant) throw new Error("There is no second plant.");
  await page.getByRole("tab", { name: "Labels" }).tap();
  await expect(app.panel).toBeHidden();
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const frames = (await app.lastFrame()) + 1;
  const x = (frame: number) => box.x + 100 + (frame / frames) * (box.width - 100 - 14);
  const y = box.y + 50;
  await page.touchscreen.tap(x((plant.start + plant.end) / 2), y);
  await expect(page.locator(".message")).toHaveText("Drag an end of the bar to correct it");
  const touch = await page.context().newCDPSession(page);
  const send = (type: "touchStart" | "touchMove", at: number) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: [{ x: at, y }] });
  await send("touchStart", x(plant.end));
  for (const to of [2, 6, 10]) await send("touchMove", x(plant.end - to));
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await app.head.getByRole("button", { name: "edited" }).tap();
  const edited = readLabels(await app.save("Labels")).left.contact?.[1];
  expect(edited?.end).toBeLessThan(plant.end - 5);
});

test("compares with labels from the file picker", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  await page.getByRole("tab", { name: "Labels" }).tap();
  const [picker] = await Promise.all([
    page.waitForEvent("filechooser"),
    app.panel.getByRole("button", { name: "Open" }).tap(),
  ]);
  await picker.setFiles(clip("samples/frog-jumps.json"));
  await expect(page.getByRole("tabpanel", { name: "Score" })).toContainText("frog-jumps.json");
  // The overview of the clip stays in sight above the raised sheet.
  const container = app.tracks.locator("xpath=..");
  await expect
    .poll(async () => (await app.tracks.boundingBox())?.height)
    .toBeLessThanOrEqual((await container.boundingBox())?.height ?? 0);
});

test("selects and moves a cut by touch", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await page.getByRole("tab", { name: "Segment" }).tap();
  const field = app.panel.getByRole("spinbutton", { name: "Cut at frame" });
  await page.getByRole("tab", { name: "Segment" }).tap();
  await expect(app.panel).toBeHidden();
  const tall = await app.tracks.boundingBox();
  if (!tall) throw new Error("The timeline has no canvas.");
  const frames = (await app.lastFrame()) + 1;
  const cut = await page.evaluate(() => {
    const rows = [...document.querySelectorAll("table")].at(-1)?.querySelectorAll("tr");
    return Number.parseFloat(rows?.[2]?.cells[3]?.textContent ?? "");
  });
  const x = tall.x + 100 + ((cut * 24) / frames) * (tall.width - 100 - 14);
  // The segments are above the overview of the clip.
  await page.touchscreen.tap(x, tall.y + tall.height - 58);
  expect(await app.frame()).toBe(Math.round(cut * 24));
  await page.getByRole("tab", { name: "Segment" }).tap();
  await expect(field).toHaveValue(String(Math.round(cut * 24)));
  await field.fill("300");
  await page.keyboard.press("Enter");
  await expect(field).toHaveValue("300");
});

test("fits all six tabs", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  await app.drop(clip("samples/frog-jumps.json"));
  for (const tab of await page.getByRole("tab").all()) {
    await expect(tab).toBeInViewport({ ratio: 1 });
  }
  await expect(page.getByRole("tab")).toHaveCount(6);
  await expectNoHorizontalScroll(app);
  await test.step("names of fields do not touch the fields", async () => {
    await app.tab("Clip");
    const names = app.panel.locator(".form-rows label > span");
    await expect(names.filter({ hasText: "Metres per unit" })).toBeVisible();
    const gaps = await names.evaluateAll((elements) =>
      elements.map((element) => {
        const text = document.createRange();
        text.selectNodeContents(element);
        const field = element.nextElementSibling?.getBoundingClientRect();
        return (field?.left ?? 0) - text.getBoundingClientRect().right;
      }),
    );
    expect(Math.min(...gaps)).toBeGreaterThanOrEqual(4);
  });
});

test("fits the share dialog", async ({ app, page }) => {
  await app.openSample("frog-jumps");
  const share = app.head.getByRole("button", { name: "Share" });
  await expect(share).toBeInViewport({ ratio: 1 });
  await share.tap();
  await expect(app.dialog).toBeInViewport({ ratio: 1 });
  for (const name of ["Copy", "Save page", "Save picture", "Close"]) {
    const button = app.dialog.getByRole("button", { name });
    await expect(button).toBeInViewport({ ratio: 1 });
    expect((await button.boundingBox())?.height).toBeGreaterThanOrEqual(44);
  }
  await expectNoHorizontalScroll(app);
  await page.setViewportSize({ width: 375, height: 667 });
  await expect(app.dialog).toBeInViewport({ ratio: 1 });
});
