/** The first minute of somebody new. */

import { expect, test } from "./app";

test.use({ isNew: true });

test("five hints are shown once, one after the other", async ({ app, page }) => {
  await app.empty();
  const tour = page.getByRole("complementary", { name: "Tour" });
  await expect(tour).toBeHidden();
  await page.getByRole("button", { name: "Curved walk" }).click();
  await app.opened("curved-walk.bvh");
  for (let i = 1; i <= 5; i++) {
    await expect(tour).toContainText(`${i} of 5`);
    // Nobody has to go on: the page works meanwhile.
    if (i === 2) expect(await app.pressRuler(0.5)).toBeGreaterThan(0);
    await tour.getByRole("button", { name: i < 5 ? "Next" : "Done" }).click();
  }
  await expect(tour).toBeHidden();
  await page.reload();
  await app.opened("curved-walk.bvh");
  await expect(tour).toBeHidden();
  await page.keyboard.press("?");
  await app.dialog.getByRole("button", { name: "Show the tour" }).click();
  await expect(tour).toContainText("1 of 5");
});

test("the tour can be ended at once", async ({ app, page }) => {
  await app.sample("bowling");
  await page.getByRole("button", { name: "End the tour" }).click();
  await expect(page.getByRole("complementary", { name: "Tour" })).toBeHidden();
  await page.reload();
  await app.opened("bowling.bvh");
  await expect(page.getByRole("complementary", { name: "Tour" })).toBeHidden();
});
