import { expect, test } from "./app";
import { bad, good, sample } from "./clips";

test("a dropped file shows its facts, its plants and its name in the title", async ({ app }) => {
  await app.empty();
  await app.drop(sample("curved-walk"));
  await app.opened("curved-walk.bvh");
  await expect(app.head).toContainText("curved-walk.bvh");
  await expect(app.head).toContainText("245 frames · 120 Hz · 2.04 s");
  await expect(app.stage).toHaveAccessibleName("The skeleton of curved-walk.bvh");
  await expect(app.playhead).toHaveAttribute("aria-valuemax", "244");
  expect((await app.result("Left")).plants).toBeGreaterThan(0);
  expect((await app.result("Right")).plants).toBeGreaterThan(0);
  await app.tab("Clip");
  await expect(app.fact("Frames")).toHaveText("245");
  await expect(app.fact("Duration")).toHaveText("2.04 s");
  await expect(app.fact("Up axis")).toHaveText("Y");
});

test("the file input opens a file, and the same one again", async ({ app, page }) => {
  await app.empty();
  for (const button of ["Open a file", "Open"]) {
    const choosing = page.waitForEvent("filechooser");
    await page.getByRole("button", { name: button, exact: true }).click();
    const chooser = await choosing;
    expect(chooser.isMultiple()).toBe(true);
    await chooser.setFiles(good("plain"));
    await app.opened("plain.bvh");
    expect(await app.lastFrame()).toBe(11);
    expect(await app.frame()).toBe(0);
    await page.keyboard.press("End");
    expect(await app.frame()).toBe(11);
  }
});

test("a pasted file opens", async ({ app }) => {
  await app.empty();
  await app.paste(good("plain"));
  await app.opened("plain.bvh");
});

test("of several files the first good one opens and the others wait in a list", async ({ app }) => {
  await app.empty();
  await app.drop(good("plain"), sample("bowling"));
  await app.opened("plain.bvh");
  await app.tab("Clip");
  await app.panel.getByRole("button", { name: /^bowling\.bvh/ }).click();
  await app.opened("bowling.bvh");
});

test("a bad file among several does not stop the good one, and is named", async ({ app, page }) => {
  await app.empty();
  await app.drop(bad("ragged-row"), good("plain"));
  await expect(page).toHaveTitle("plain.bvh – Plantigrade");
  await expect(app.playhead).toBeVisible();
  await expect(page.getByText(/ragged-row\.bvh.*(not|refused|error)/i)).toBeVisible();
});

test("a new clip takes the place of the one before", async ({ app }) => {
  await app.sample("bowling");
  await app.page.keyboard.press("End");
  await app.drop(good("plain"));
  await app.opened("plain.bvh");
  expect(await app.frame()).toBe(0);
  await expect(app.page).toHaveURL(app.site.home);
});
