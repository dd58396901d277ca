/** Space for the view, the timeline and the panel on pages of every size. */

import { type App, expect, test } from "./app";
import { bad, clip, good, sample } from "./clips";
import { atEachSize, viewports } from "./viewports";

const container = (app: App) => app.tracks.locator("xpath=..");

/** Returns the horizontal position of the middle of the view, where the character is. */
async function middleOfView(app: App): Promise<number> {
  const { x = 0, width = 0 } = (await app.stage.boundingBox()) ?? {};
  return x + width / 2;
}

atEachSize((size) => {
  test("undo and redo are at the same place for plants and cuts", async ({ app }) => {
    await app.openSample("curved-walk");
    const places: number[][] = [];
    for (const tab of ["Labels", "Segment"] as const) {
      await app.tab(tab);
      const head = app.panel.locator(".field-head:has(.undo)");
      await head.scrollIntoViewIfNeeded();
      const boxes = await Promise.all(
        [head.locator("h2"), head.locator(".undo"), head.locator(".redo")].map((item) =>
          item.boundingBox(),
        ),
      );
      const [title = 0, undo = 0, redo = 0] = boxes.map((box) => box && box.y + box.height / 2);
      expect(Math.abs((undo ?? 0) - (title ?? 0))).toBeLessThan(2);
      expect(redo).toBe(undo);
      places.push(boxes.slice(1).map((box) => box?.x ?? 0));
    }
    expect(places[1]).toEqual(places[0]);
  });

  test("shows view, timeline and panel without squeezing any", async ({ app, page }) => {
    await app.openSample("curved-walk");
    const minimum = viewports[size].height <= 560 ? 150 : 180;
    expect((await app.stage.boundingBox())?.height).toBeGreaterThanOrEqual(minimum);
    await expect(container(app)).toBeInViewport({ ratio: 1 });
    // Ruler, both feet and the overview fit without scrolling.
    expect((await app.tracks.boundingBox())?.height).toBeLessThanOrEqual(
      (await container(app).boundingBox())?.height ?? 0,
    );
    await expect(app.timeline.getByRole("button", { name: "Play" })).toBeInViewport({ ratio: 1 });
    await expect(app.timeline.getByRole("button", { name: "Fit" })).toBeInViewport({ ratio: 1 });
    await page.getByRole("tab", { name: "Labels" }).click();
    await expect(page.getByRole("tabpanel", { name: "Labels" })).toBeInViewport({ ratio: 0.9 });
    await expect(container(app)).toBeInViewport({ ratio: 1 });
    expect((await app.stage.boundingBox())?.height).toBeGreaterThanOrEqual(minimum);
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(overflow).toBe(0);
    await test.step("the labels of the feet do not cover the character", async () => {
      // On a phone, they have a row.
      if (size === "phone") return;
      const middle = await middleOfView(app);
      for (const pill of await app.view.locator(".pill").all())
        expect((await pill.boundingBox())?.x).toBeGreaterThan(middle + 10);
    });
    await test.step("shows the playhead in the overview", async () => {
      const marker = app.timeline.locator(".minimap-playhead");
      const x = async () => (await marker.boundingBox())?.x ?? 0;
      const before = await x();
      const { width = 0 } = (await app.tracks.boundingBox()) ?? {};
      await page.keyboard.press("End");
      await expect.poll(x).toBeGreaterThan(before + 0.6 * width);
    });
  });

  test("hides tracks, remembers it, and explains the marks", async ({ app, page }) => {
    await app.openSample("curved-walk");
    const menu = app.timeline.getByRole("button", { name: "Tracks" });
    // A small timeline has no space for some tracks, and lists them.
    const shown = async () =>
      (await app.tracks.screenshot()).toString("base64") +
      (await app.timeline.getByText(/^There is no space/).allInnerTexts()).join();
    await menu.click();
    await expect(app.timeline.getByText("Low confidence: review these frames")).toBeVisible();
    const panel = app.timeline.locator(".menu-panel");
    await expect(panel).toBeInViewport({ ratio: 1 });
    expect((await panel.boundingBox())?.height).toBeGreaterThan(120);
    const before = await shown();
    await app.timeline.getByRole("checkbox", { name: "Height and speed" }).uncheck();
    await expect.poll(async () => (await shown()) === before).toBe(false);
    await page.keyboard.press("Escape");
    await expect(app.timeline.getByRole("checkbox", { name: "Segments" })).toBeHidden();
    await page.reload();
    await app.waitForClip("curved-walk.bvh");
    await menu.click();
    await expect(
      app.timeline.getByRole("checkbox", { name: "Height and speed" }),
    ).not.toBeChecked();
  });

  test("the list follows the selection", async ({ app, page }) => {
    await app.openSample("ballet");
    await app.tab("Labels");
    await page.keyboard.press("End");
    await page.keyboard.press("Shift+ArrowLeft");
    await page.keyboard.press("e");
    const selected = app.panel.getByRole("button", { pressed: true });
    await expect(selected).toBeInViewport({ ratio: 0.9 });
    // All columns fit.
    const overflow = await selected.evaluate((row) => row.scrollWidth - row.clientWidth);
    expect(overflow).toBe(0);
    await test.step("what an edit did does not cover the character", async () => {
      if (size === "phone") return;
      await page.keyboard.press("w");
      const message = page.locator(".message");
      await expect(message).toBeVisible();
      const { x = 0, width = 0 } = (await message.boundingBox()) ?? {};
      expect(x + width).toBeLessThan((await middleOfView(app)) - 10);
    });
  });

  test("leaves space for every tab, segments, references and clips side by side", async ({
    app,
    page,
  }) => {
    await app.openSample("limp-to-run");
    await test.step("every tab begins at its top", async () => {
      await app.tab("Clip");
      const scrollTop = () => app.panel.evaluate((panel) => panel.scrollTop);
      await app.panel.evaluate((panel) => panel.scrollTo(0, panel.scrollHeight));
      expect(await scrollTop()).toBeGreaterThan(0);
      await app.tab("Labels");
      expect(await scrollTop()).toBe(0);
    });
    await test.step("shows the segments while their tab is open", async () => {
      await app.tab("Segment");
      await expect(app.panel.getByRole("textbox", { name: "Name of segment 1" })).toBeAttached();
      await app.timeline.getByRole("button", { name: "Tracks" }).click();
      const notice = app.timeline.getByText(/^There is no space/);
      expect((await notice.allInnerTexts()).join()).not.toContain("segments");
      await page.keyboard.press("Escape");
    });
    await test.step("shows the segments below reference labels", async () => {
      await app.drop(clip("samples/limp-to-run.json"));
      await expect(page.getByRole("tab", { name: "Score" })).toBeVisible();
      await app.tab("Segment");
      await expect(app.panel.getByRole("textbox", { name: "Name of segment 1" })).toBeAttached();
      await app.timeline.getByRole("button", { name: /^Tracks/ }).click();
      const notice = app.timeline.getByText(/^There is no space/);
      expect((await notice.allInnerTexts()).join()).not.toContain("segments");
      await page.keyboard.press("Escape");
    });
    await test.step("leaves the overview in sight with clips side by side", async () => {
      await app.drop(sample("bowling"), sample("frog-jumps"));
      for (const name of ["bowling", "frog-jumps"]) {
        const button = page.getByRole("button", { name: `${name}.bvh side by side` });
        await button.focus();
        await page.keyboard.press("Enter");
        await expect(button).toHaveAttribute("aria-pressed", "true");
      }
      await page.getByRole("button", { name: "Back to limp-to-run.bvh" }).click();
      await expect(page.getByRole("list", { name: "Comparison clips" })).toBeVisible();
      const { height = 0 } = (await app.tracks.boundingBox()) ?? {};
      expect(height).toBeLessThanOrEqual((await container(app).boundingBox())?.height ?? 0);
    });
  });

  test("shows the names of clips in the table, and marks a tab of each clip", async ({
    app,
    page,
  }) => {
    await app.openStartPage();
    await app.drop(sample("bowling"), sample("frog-jumps"), clip("samples/frog-jumps.json"));
    await expect(page.getByText(/^All processed/)).toBeVisible();
    const name = page.getByRole("button", { name: "frog-jumps.bvh", exact: true });
    const start = name.locator(".name-start");
    expect(await start.evaluate((text) => text.scrollWidth - text.clientWidth)).toBe(0);
    await name.click();
    await expect(page.getByRole("tab", { name: "Score", selected: true })).toBeVisible();
    expect((await app.head.getByText("frog-jumps.bvh").boundingBox())?.width).toBeGreaterThan(60);
    await page.keyboard.press("n");
    await app.waitForClip("bowling.bvh");
    await expect(page.getByRole("tab", { selected: true })).toHaveCount(1);
  });

  test("shows the tab of a comparison, also in a hidden panel", async ({ app, page }) => {
    await app.openSample("frog-jumps");
    await page.keyboard.press("p");
    await app.drop(clip("samples/frog-jumps.json"));
    const panel = page.getByRole("tabpanel", { name: "Score" });
    await expect(panel).toBeInViewport({ ratio: 0.9 });
    await expect(panel).toContainText("frog-jumps.json");
    const { height = 0 } = (await app.tracks.boundingBox()) ?? {};
    expect(height).toBeLessThanOrEqual((await container(app).boundingBox())?.height ?? 0);
  });
});

// The sheet of a phone has one height.
atEachSize(
  (size) => {
    const { width, height } = viewports[size];

    test("resizes the timeline by drag and by keys, and remembers it", async ({ app, page }) => {
      await app.openSample("curved-walk");
      const splitter = page.getByRole("separator", { name: "Height of the timeline" });
      const tracksHeight = async () => (await container(app).boundingBox())?.height ?? 0;
      const before = await tracksHeight();
      const minimum = height <= 560 ? 150 : 200;
      const available = ((await app.stage.boundingBox())?.height ?? 0) - minimum;
      const by = Math.min(100, available);
      const box = await splitter.boundingBox();
      if (!box) throw new Error("There is no splitter.");
      await page.mouse.move(box.x + 300, box.y + 1);
      await page.mouse.down();
      await page.mouse.move(box.x + 300, box.y - 99, { steps: 4 });
      await page.mouse.up();
      await expect.poll(tracksHeight).toBeCloseTo(before + by, -1);
      await splitter.focus();
      await page.keyboard.press("ArrowDown");
      await expect.poll(tracksHeight).toBeCloseTo(before + by - 24, -1);
      await page.reload();
      await app.waitForClip("curved-walk.bvh");
      await expect.poll(tracksHeight).toBeCloseTo(before + by - 24, -1);
      // The view retains its minimum height.
      await splitter.focus();
      for (let i = 0; i < 40; i++) await page.keyboard.press("ArrowUp");
      expect((await app.stage.boundingBox())?.height).toBeGreaterThanOrEqual(minimum);
      await splitter.dblclick();
      await expect.poll(tracksHeight).toBeCloseTo(before, -1);
    });

    test("resizes and hides the panel, and remembers it", async ({ app, page }) => {
      await app.openSample("curved-walk");
      const splitter = page.getByRole("separator", { name: "Width of the panel" });
      const panelWidth = async () => (await page.locator(".panel").boundingBox())?.width ?? 0;
      const before = width > 900 ? 320 : 290;
      expect(await panelWidth()).toBeCloseTo(before, -1);
      await splitter.focus();
      await page.keyboard.press("ArrowLeft");
      await expect.poll(panelWidth).toBeCloseTo(before + 24, -1);
      // The panel has the full height.
      expect((await page.locator(".panel").boundingBox())?.height).toBeGreaterThan(height - 60);
      const toggle = app.head.getByRole("button", { name: "Panel" });
      await toggle.click();
      await expect(page.locator(".panel")).toBeHidden();
      await page.reload();
      await app.waitForClip("curved-walk.bvh");
      await expect(page.locator(".panel")).toBeHidden();
      await page.keyboard.press("p");
      await expect.poll(panelWidth).toBeCloseTo(before + 24, -1);
    });
  },
  ["phone"],
);

test("shows edited plants, also in a hidden panel", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await page.keyboard.press("p");
  await app.head.getByRole("button", { name: "edited" }).click();
  await expect(page.getByRole("tabpanel", { name: "Labels" })).toBeVisible();
});

test("a comparison makes a timeline higher whose height the user has set", async ({
  app,
  page,
}) => {
  await app.openSample("limp-to-run");
  const height = async () => (await container(app).boundingBox())?.height ?? 0;
  const splitter = page.getByRole("separator", { name: "Height of the timeline" });
  await splitter.focus();
  await page.keyboard.press("ArrowUp");
  const own = await height();
  const tracks = app.timeline.getByRole("button", { name: /^Tracks/ });
  await expect(tracks).toHaveText("Tracks");
  await app.drop(clip("samples/limp-to-run.json"));
  await expect.poll(height).toBe(own + 72);
  await expect(tracks).toHaveText("Tracks");
  // A height that is set during the comparison is that without its tracks.
  await splitter.focus();
  await page.keyboard.press("ArrowUp");
  await expect.poll(height).toBe(own + 96);
  await app.panel.getByRole("button", { name: "Remove" }).click();
  await expect.poll(height).toBe(own + 24);
});

test("the error card fits on the page, also after a clip with a long name", async ({
  app,
  page,
}) => {
  const name = `${"walk_".repeat(26)}.bvh`;
  await app.openFile({ ...good("plain"), name });
  await app.drop({ ...bad("not-a-number"), name: `bad_${name}` });
  for (const viewport of [viewports.desktop, viewports.phone]) {
    await page.setViewportSize(viewport);
    await expect(app.alert).toContainText("is still open");
    const card = await app.alert.boundingBox();
    expect(card?.x).toBeGreaterThanOrEqual(0);
    expect((card?.x ?? 0) + (card?.width ?? 0)).toBeLessThanOrEqual(viewport.width);
    expect(await app.alert.evaluate((card) => card.scrollWidth - card.clientWidth)).toBe(0);
    const dismiss = app.alert.getByRole("button", { name: "Dismiss" });
    await expect(dismiss).toBeInViewport({ ratio: 1 });
  }
  await app.alert.getByRole("button", { name: "Dismiss" }).click();
  await expect(app.alert).toBeHidden();
});
