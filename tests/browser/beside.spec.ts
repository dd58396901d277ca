/** Clips side by side. */

import { expect, test } from "./app";
import { bad, sample } from "./clips";

test("clips stand side by side, linked in time, and go away again", async ({ app, page }) => {
  await app.empty();
  await app.drop(sample("curved-walk"), sample("bowling"), sample("frog-jumps"), bad("empty"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  // Beside what? First a clip has to be open.
  await expect(page.getByRole("button", { name: /side by side/ })).toHaveCount(0);
  await page.getByRole("button", { name: "curved-walk.bvh", exact: true }).click();
  await app.opened("curved-walk.bvh");
  const alone = await app.stillPicture();
  await page.getByRole("button", { name: "4 clips" }).click();
  for (const name of ["bowling", "frog-jumps"]) {
    const beside = page.getByRole("button", {
      name: `${name}.bvh side by side with curved-walk.bvh`,
    });
    await beside.focus();
    await page.keyboard.press("Enter");
    await expect(beside).toHaveAttribute("aria-pressed", "true");
  }
  await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
  const shown = page.getByRole("list", { name: "Comparison clips" });
  await expect(shown.getByRole("listitem")).toHaveText(["bowling.bvh", "frog-jumps.bvh"]);
  await expect.poll(async () => (await app.picture()) === alone).toBe(false);
  // They come along when another clip is opened, and leave by a button.
  await page.keyboard.press("End");
  await page.getByRole("button", { name: "Remove bowling.bvh from the comparison" }).click();
  await expect(shown.getByRole("listitem")).toHaveText(["frog-jumps.bvh"]);
  await page.getByRole("button", { name: "Remove frog-jumps.bvh from the comparison" }).click();
  await expect(shown).toBeHidden();
});
