/** Space for the view, the timeline and the panel on pages of every size. */

import { type App, expect, test } from "./app";
import { eachViewport } from "./viewports";

const container = (app: App) => app.tracks.locator("xpath=..");

for (const [name, viewport] of eachViewport) {
  test.describe(name, () => {
    test.use({ viewport });

    test("shows view, timeline and panel without squeezing any", async ({ app, page }) => {
      await app.openSample("curved-walk");
      const minimum = viewport.height <= 560 ? 150 : 180;
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
    });
  });
}

test("resizes the timeline by drag and by keys, and remembers it", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const splitter = page.getByRole("separator", { name: "Height of the timeline" });
  const height = async () => (await container(app).boundingBox())?.height ?? 0;
  const before = await height();
  const box = await splitter.boundingBox();
  if (!box) throw new Error("There is no splitter.");
  await page.mouse.move(box.x + 300, box.y + 1);
  await page.mouse.down();
  await page.mouse.move(box.x + 300, box.y - 99, { steps: 4 });
  await page.mouse.up();
  await expect.poll(height).toBeCloseTo(before + 100, -1);
  await splitter.focus();
  await page.keyboard.press("ArrowDown");
  await expect.poll(height).toBeCloseTo(before + 76, -1);
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(height).toBeCloseTo(before + 76, -1);
  // The view retains its minimum height.
  await splitter.focus();
  for (let i = 0; i < 40; i++) await page.keyboard.press("ArrowUp");
  expect((await app.stage.boundingBox())?.height).toBeGreaterThanOrEqual(200);
  await splitter.dblclick();
  await expect.poll(height).toBeCloseTo(before, -1);
});

test("resizes and hides the panel, and remembers it", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const splitter = page.getByRole("separator", { name: "Width of the panel" });
  const width = async () => (await page.locator(".panel").boundingBox())?.width ?? 0;
  expect(await width()).toBeCloseTo(320, -1);
  await splitter.focus();
  await page.keyboard.press("ArrowLeft");
  await expect.poll(width).toBeCloseTo(344, -1);
  // The panel has the full height.
  expect((await page.locator(".panel").boundingBox())?.height).toBeGreaterThan(840);
  const toggle = app.head.getByRole("button", { name: "Panel" });
  await toggle.click();
  await expect(page.locator(".panel")).toBeHidden();
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect(page.locator(".panel")).toBeHidden();
  await page.keyboard.press("p");
  await expect.poll(width).toBeCloseTo(344, -1);
});

test("hides tracks, remembers it, and explains the marks", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const menu = app.timeline.getByRole("button", { name: "Tracks" });
  await menu.click();
  await expect(app.timeline.getByText("Low confidence: review these frames")).toBeVisible();
  const before = await app.tracks.screenshot();
  await app.timeline.getByRole("checkbox", { name: "Height and speed" }).uncheck();
  await expect.poll(async () => before.equals(await app.tracks.screenshot())).toBe(false);
  await page.keyboard.press("Escape");
  await expect(app.timeline.getByRole("checkbox", { name: "Segments" })).toBeHidden();
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await menu.click();
  await expect(app.timeline.getByRole("checkbox", { name: "Height and speed" })).not.toBeChecked();
});

test("shows the playhead in the overview", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const marker = app.timeline.locator(".minimap-playhead");
  const x = async () => (await marker.boundingBox())?.x ?? 0;
  const before = await x();
  await page.keyboard.press("End");
  await expect.poll(x).toBeGreaterThan(before + 500);
});
