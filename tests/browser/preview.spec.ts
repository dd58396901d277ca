/** The preview of the start page, and starting to play. */

import { type App, expect, test } from "./app";

/** Opens the page with the preview blocked. Returns a function that lets it load. */
async function openWithoutPreview(app: App): Promise<() => void> {
  let release = () => {};
  const released = new Promise<void>((resolve) => {
    release = resolve;
  });
  await app.page.route("**/*.bvh", async (route) => {
    await released;
    await route.continue();
  });
  await app.page.goto(app.site.home);
  await expect(app.state).toHaveAttribute("data-state", "empty");
  await app.page.mouse.move(2, 2);
  return release;
}

/** Opens the page and waits until the preview is drawn. */
async function openWithPreview(app: App) {
  const release = await openWithoutPreview(app);
  const without = await app.picture();
  release();
  await expect.poll(async () => (await app.picture()) === without).toBe(false);
}

test("the preview plays on the start page", async ({ app, page }) => {
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await openWithPreview(app);
  const before = await app.picture();
  await expect.poll(async () => (await app.picture()) === before).toBe(false);
});

test("the preview does not move if reduced motion is preferred", async ({ app }) => {
  await openWithPreview(app);
  // The labels arrive later and change the picture once.
  await expect(async () => {
    const before = await app.picture();
    await app.animationFrames(30);
    expect((await app.picture()) === before).toBe(true);
  }).toPass();
});

test("a clip plays when it is opened, unless reduced motion is preferred", async ({
  app,
  page,
}) => {
  await app.openSample("bowling");
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeVisible();
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.reload();
  await app.waitForClip("bowling.bvh");
  await expect(app.timeline.getByRole("button", { name: "Pause" })).toBeVisible();
});
