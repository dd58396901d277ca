/** Clips shown side by side. */

import { expect, test } from "./app";
import { bad, sample } from "./clips";

test("shows clips side by side and removes them", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(sample("curved-walk"), sample("bowling"), sample("frog-jumps"), bad("empty"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  // The button requires an open clip.
  await expect(page.getByRole("button", { name: /side by side/ })).toHaveCount(0);
  await page.getByRole("button", { name: "curved-walk.bvh", exact: true }).click();
  await app.waitForClip("curved-walk.bvh");
  const alone = await app.stillPicture();
  await page.getByRole("button", { name: "4 clips" }).click();
  for (const name of ["bowling", "frog-jumps"]) {
    const button = page.getByRole("button", {
      name: `${name}.bvh side by side with curved-walk.bvh`,
    });
    await button.focus();
    await page.keyboard.press("Enter");
    await expect(button).toHaveAttribute("aria-pressed", "true");
  }
  await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
  const shown = page.getByRole("list", { name: "Comparison clips" });
  await expect(shown.getByRole("listitem")).toHaveText(["bowling.bvh", "frog-jumps.bvh"]);
  await expect.poll(async () => (await app.picture()) === alone).toBe(false);
  // Each clip has a button that removes it.
  await page.keyboard.press("End");
  await page.getByRole("button", { name: "Remove bowling.bvh from the comparison" }).click();
  await expect(shown.getByRole("listitem")).toHaveText(["frog-jumps.bvh"]);
  await page.getByRole("button", { name: "Remove frog-jumps.bvh from the comparison" }).click();
  await expect(shown).toBeHidden();
});

test("does not show a clip side by side with itself", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.drop(sample("curved-walk"), sample("bowling"), sample("frog-jumps"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  // The row of the sample that was opened before.
  const sideBySide = (name: string, open: string) =>
    page.getByRole("button", { name: `${name}.bvh side by side with ${open}.bvh` });
  await expect(sideBySide("bowling", "curved-walk")).toBeAttached();
  await expect(sideBySide("curved-walk", "curved-walk")).toHaveCount(0);
  await sideBySide("bowling", "curved-walk").focus();
  await page.keyboard.press("Enter");
  await sideBySide("frog-jumps", "curved-walk").focus();
  await page.keyboard.press("Enter");
  await expect(sideBySide("frog-jumps", "curved-walk")).toHaveAttribute("aria-pressed", "true");
  // A comparison clip that is opened is no longer one.
  await page.getByRole("button", { name: "bowling.bvh", exact: true }).click();
  await app.waitForClip("bowling.bvh");
  const shown = page.getByRole("list", { name: "Comparison clips" });
  await expect(shown.getByRole("listitem")).toHaveText(["frog-jumps.bvh"]);
  // Also if it is opened from elsewhere.
  await app.openSample("frog-jumps");
  await expect(shown.getByRole("listitem")).toHaveText(["bowling.bvh"]);
});

test("a comparison belongs to the clip and the table in which it was chosen", async ({
  app,
  page,
}) => {
  const shown = page.getByRole("list", { name: "Comparison clips" });
  const choose = async (name: string) => {
    await page.getByRole("button", { name: `${name}.bvh side by side with` }).focus();
    await page.keyboard.press("Enter");
  };
  await app.openSample("curved-walk");
  await app.drop(sample("bowling"), sample("frog-jumps"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await choose("bowling");
  await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
  await expect(shown.getByRole("listitem")).toHaveText(["bowling.bvh"]);
  await test.step("it is closed with a clip from elsewhere", async () => {
    await app.drop(sample("ballet"));
    await app.waitForClip("ballet.bvh");
    await expect(shown).toBeHidden();
  });
  await test.step("it is not resumed by the comparison of another clip", async () => {
    await app.head.getByRole("button", { name: "2 clips" }).click();
    const button = page.getByRole("button", { name: "bowling.bvh side by side with ballet.bvh" });
    await expect(button).toHaveAttribute("aria-pressed", "false");
    await choose("frog-jumps");
    await page.getByRole("button", { name: "Back to ballet.bvh" }).click();
    await expect(shown.getByRole("listitem")).toHaveText(["frog-jumps.bvh"]);
  });
  await test.step("it is closed with a clip of another table", async () => {
    await app.drop(sample("bowling"), sample("one-leg-hop"));
    await expect(page.getByText(/^All processed/)).toBeVisible();
    await page.getByRole("button", { name: "one-leg-hop.bvh", exact: true }).click();
    await app.waitForClip("one-leg-hop.bvh");
    await expect(shown).toBeHidden();
  });
});
