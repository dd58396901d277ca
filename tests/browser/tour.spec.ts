/** The tour for new users. */

import { type App, expect, test } from "./app";
import { atEachSize } from "./viewports";

test.use({ isNew: true });

const tourOf = (app: App) => app.page.getByRole("complementary", { name: "Tour" });

/** Opens a clip of one's own. */
async function openFromStartPage(app: App) {
  await app.openStartPage();
  await expect(tourOf(app)).toBeHidden();
  await app.page.getByRole("button", { name: "Curved walk" }).click();
  await app.waitForClip("curved-walk.bvh");
}

/** Follows a link, which does not start the tour, and asks for it. */
async function openLinkWithTour(app: App) {
  await app.openSample("curved-walk");
  await expect(tourOf(app)).toBeHidden();
  await app.head.getByRole("button", { name: "Keyboard shortcuts" }).click();
  await app.dialog.getByRole("button", { name: "Show the tour" }).click();
  await expect(tourOf(app)).toContainText("1 of 5");
}

test("shows five hints once", async ({ app, page }) => {
  await openFromStartPage(app);
  const tour = tourOf(app);
  for (let i = 1; i <= 5; i++) {
    await expect(tour).toContainText(`${i} of 5`);
    // The tour does not block the page.
    if (i === 2) expect(await app.pressRuler(0.5)).toBeGreaterThan(0);
    await tour.getByRole("button", { name: i < 5 ? "Next" : "Done" }).click();
  }
  await expect(tour).toBeHidden();
  await openFromStartPage(app);
  await expect(tour).toBeHidden();
  await page.keyboard.press("?");
  await app.dialog.getByRole("button", { name: "Show the tour" }).click();
  await expect(tour).toContainText("1 of 5");
});

test("Escape ends the tour, then deselects", async ({ app, page }) => {
  await openFromStartPage(app);
  const tour = tourOf(app);
  await expect(tour).toBeVisible();
  await page.keyboard.press("e");
  await app.tab("Labels");
  const selected = app.panel.getByRole("button", { pressed: true });
  await expect(selected).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(tour).toBeHidden();
  await expect(selected).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(selected).toBeHidden();
  await openFromStartPage(app);
  await expect(tour).toBeHidden();
});

test.describe("on a touch screen", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("explains gestures instead of keys", async ({ app }) => {
    await openLinkWithTour(app);
    const tour = tourOf(app);
    const next = tour.getByRole("button", { name: /Next|Done/ });
    for (let i = 1; i <= 5; i++) {
      await expect(tour).toContainText(`${i} of 5`);
      await expect(tour).not.toContainText(/Ctrl|Press|Click|Drop/);
      if (i === 3) await expect(tour).toContainText("Tap a bar, then drag its ends");
      await next.tap();
    }
    await expect(tour).toBeHidden();
  });
});

test("ends the tour at the first hint", async ({ app, page }) => {
  await openFromStartPage(app);
  await page.getByRole("button", { name: "End the tour" }).click();
  await expect(tourOf(app)).toBeHidden();
  await openFromStartPage(app);
  await expect(tourOf(app)).toBeHidden();
});

atEachSize(() => {
  test("the tour does not cover what it describes", async ({ app, page }) => {
    await openLinkWithTour(app);
    const tour = tourOf(app);
    const described = [app.stage, app.tracks, app.tracks, page.locator(".panel-head"), app.head];
    for (const part of described) {
      const [a, b] = [await tour.boundingBox(), await part.boundingBox()];
      if (!a || !b) throw new Error("The tour or what it describes is not displayed.");
      const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
      const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
      expect(Math.min(width, height)).toBeLessThanOrEqual(0);
      await expect(tour).toBeInViewport({ ratio: 1 });
      await tour.getByRole("button", { name: /Next|Done/ }).click();
    }
  });
});
