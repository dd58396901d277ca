/** Paths of the toes and hips. */

import { expect, test } from "./app";

test("draws paths while they are enabled", async ({ app, page }) => {
  await app.openSample("curved-walk");
  for (let i = 0; i < 60; i++) await page.keyboard.press("ArrowRight");
  const without = await app.stillPicture();
  const paths = page.getByRole("button", { name: "Paths" });
  await page.keyboard.press("t");
  await expect(paths).toHaveAttribute("aria-pressed", "true");
  await expect.poll(async () => (await app.picture()) === without).toBe(false);
  await paths.click();
  await expect(paths).toHaveAttribute("aria-pressed", "false");
  // The pointer must not highlight anything in the picture.
  await page.mouse.move(5, 5);
  await expect.poll(async () => (await app.picture()) === without).toBe(true);
});
