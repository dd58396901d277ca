/** The ways of toes and hips. */

import { expect, test } from "./app";

test("paths are drawn when asked for, and go with the moment", async ({ app, page }) => {
  await app.sample("curved-walk");
  for (let i = 0; i < 60; i++) await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(300);
  const without = await app.stage.screenshot();
  const paths = page.getByRole("button", { name: "Paths" });
  await page.keyboard.press("t");
  await expect(paths).toHaveAttribute("aria-pressed", "true");
  await page.waitForTimeout(300);
  expect(without.equals(await app.stage.screenshot())).toBe(false);
  await paths.click();
  await page.mouse.move(5, 5);
  await page.waitForTimeout(300);
  expect(without.equals(await app.stage.screenshot())).toBe(true);
});
