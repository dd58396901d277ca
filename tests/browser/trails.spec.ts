/** Trails of the toes and hips. */

import { expect, test } from "./app";

test("draws trails while they are enabled", async ({ app, page }) => {
  await app.openSample("curved-walk");
  for (let i = 0; i < 60; i++) await page.keyboard.press("ArrowRight");
  const without = await app.stillPicture();
  const trails = page.getByRole("button", { name: "Trails" });
  await page.keyboard.press("t");
  await expect(trails).toHaveAttribute("aria-pressed", "true");
  await expect.poll(async () => (await app.picture()) === without).toBe(false);
  await trails.click();
  await expect(trails).toHaveAttribute("aria-pressed", "false");
  // The pointer must not highlight anything in the picture.
  await page.mouse.move(5, 5);
  await expect.poll(async () => (await app.picture()) === without).toBe(true);
});
