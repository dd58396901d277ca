import { expect, test } from "./app";
import { bad, good, sample } from "./clips";

test("shows properties and plants of a dropped file", async ({ app }) => {
  await app.openStartPage();
  await app.drop(sample("curved-walk"));
  await app.waitForClip("curved-walk.bvh");
  await expect(app.head).toContainText("curved-walk.bvh");
  await expect(app.head).toContainText("245 frames · 120 Hz · 2.04 s");
  await expect(app.stage).toHaveAccessibleName("Skeleton of curved-walk.bvh");
  await expect(app.playhead).toHaveAttribute("aria-valuemax", "244");
  expect((await app.result("Left")).plants).toBeGreaterThan(0);
  expect((await app.result("Right")).plants).toBeGreaterThan(0);
  await app.tab("Clip");
  await expect(app.fact("Frames")).toHaveText("245");
  await expect(app.fact("Duration")).toHaveText("2.04 s");
  await expect(app.fact("Up axis")).toHaveText("Y");
});

test("opens the same file twice from the file picker", async ({ app, page }) => {
  await app.openStartPage();
  for (const button of ["Open a file", "Open"]) {
    const choosing = page.waitForEvent("filechooser");
    await page.getByRole("button", { name: button, exact: true }).click();
    const chooser = await choosing;
    expect(chooser.isMultiple()).toBe(true);
    await chooser.setFiles(good("plain"));
    await app.waitForClip("plain.bvh");
    expect(await app.lastFrame()).toBe(11);
    expect(await app.frame()).toBe(0);
    await page.keyboard.press("End");
    expect(await app.frame()).toBe(11);
  }
});

test("opens a pasted file", async ({ app }) => {
  await app.openStartPage();
  await app.paste(good("plain"));
  await app.waitForClip("plain.bvh");
});

test("opens a file with invalid values leniently", async ({ app }) => {
  await app.openStartPage();
  await app.drop(bad("ragged-row"));
  await expect(app.alert.getByRole("button", { name: "Open leniently" })).toBeHidden();
  await app.drop(bad("not-a-number"));
  await expect(app.alert).toContainText("Expected a number");
  await app.alert.getByRole("button", { name: "Open leniently" }).click();
  await app.waitForClip("not-a-number.bvh");
  await expect(app.alert).toBeHidden();
  await expect(app.head.getByRole("button", { name: /notice/ })).toBeVisible();
});

test("hides the file input", async ({ app, page }) => {
  await app.openSample("bowling");
  await expect(page.locator("input[type=file]")).toBeHidden();
  await expect(page.getByRole("button", { name: /^Open/ })).toHaveCount(1);
});

test("replaces the open clip", async ({ app }) => {
  await app.openSample("bowling");
  await app.page.keyboard.press("End");
  await app.drop(good("plain"));
  await app.waitForClip("plain.bvh");
  expect(await app.frame()).toBe(0);
  await expect(app.page).toHaveURL(app.site.home);
});
