import { type App, expect, test } from "./app";

/** Opens the page with its moving picture held back; gives back how to let it come. */
async function openHeld(app: App): Promise<() => void> {
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await app.page.route("**/*.bvh", async (route) => {
    await held;
    await route.continue();
  });
  // A picture stands for it: nothing is drawn before it has come.
  await app.page.goto(app.site.home);
  await expect(app.state).toHaveAttribute("data-state", "empty");
  await app.page.mouse.move(2, 2);
  return release;
}

const picture = async (app: App) => (await app.stage.screenshot()).toString("base64");

/** Waits until the walker of the empty page has come into the picture. */
async function letCome(app: App) {
  const release = await openHeld(app);
  const without = await picture(app);
  release();
  await expect.poll(() => picture(app)).not.toBe(without);
}

test("a person walks behind the empty page", async ({ app, page }) => {
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await letCome(app);
  const before = await picture(app);
  await page.waitForTimeout(400);
  expect(await picture(app)).not.toBe(before);
});

test("who prefers less motion sees the empty page stand still", async ({ app, page }) => {
  await letCome(app);
  // What comes late, as the labels do, changes the picture once and for all.
  let before = await picture(app);
  await expect(async () => {
    const now = await picture(app);
    const same = now === before;
    before = now;
    expect(same).toBe(true);
  }).toPass({ intervals: [400] });
  await page.waitForTimeout(1000);
  expect(await picture(app)).toBe(before);
});

test("a clip plays as soon as it opens, unless less motion is preferred", async ({ app, page }) => {
  await app.sample("bowling");
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeVisible();
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.reload();
  await app.opened("bowling.bvh");
  await expect(app.timeline.getByRole("button", { name: "Pause" })).toBeVisible();
});
