/** Ways home: the logo, Back and Forward, and messages about what was restored. */

import { expect, test } from "./app";
import { sample } from "./clips";
import { atEachSize } from "./viewports";

test("Back after a reload does not open a clip that was opened since", async ({ app, page }) => {
  await app.openStartPage();
  for (const name of ["bowling", "frog-jumps"]) {
    await app.drop(sample(name));
    await app.waitForClip(`${name}.bvh`);
  }
  await page.reload();
  await app.drop(sample("curved-walk"));
  await app.waitForClip("curved-walk.bvh");
  for (const _ of [1, 2]) {
    await page.goBack();
    await expect(app.state).toHaveAttribute("data-state", "empty");
  }
});

atEachSize(() => {
  test("the logo leads to the start page, and Back to the clip", async ({ app, page }) => {
    await app.openStartPage();
    await app.drop(sample("bowling"));
    await app.waitForClip("bowling.bvh");
    await app.head.getByRole("button", { name: /start page$/ }).click();
    await expect(app.state).toHaveAttribute("data-state", "empty");
    await page.getByRole("button", { name: "Frog jumps", exact: true }).click();
    await app.waitForClip("frog-jumps.bvh");
    await page.goBack();
    await expect(app.state).toHaveAttribute("data-state", "empty");
    await page.goBack();
    await app.waitForClip("bowling.bvh");
    await page.goForward();
    await page.goForward();
    await app.waitForClip("frog-jumps.bvh");
  });

  test("Back leads from the first clip to the start page", async ({ app, page }) => {
    await app.openStartPage();
    await page.getByRole("button", { name: "Bowling", exact: true }).click();
    await app.waitForClip("bowling.bvh");
    await page.goBack();
    await expect(app.state).toHaveAttribute("data-state", "empty");
    await expect(page.getByRole("button", { name: "Open a file" })).toBeVisible();
  });

  test("clears messages, and reports that stored edits were applied", async ({ app, page }) => {
    await app.openSample("curved-walk");
    await test.step("clears messages in the live region", async () => {
      await page.keyboard.press("e");
      const status = page.locator("p[role=status]");
      await expect(status).toContainText("selected");
      await expect(status).toBeEmpty();
    });
    await test.step("reports that stored edits were applied", async () => {
      await expect(app.head.getByRole("button", { name: "edited" })).toBeHidden();
      await page.keyboard.press("e");
      await page.keyboard.press("Delete");
      await expect(app.head.getByRole("button", { name: "edited" })).toBeVisible();
      await expect(app.toast).toBeHidden();
      await page.reload();
      await app.waitForClip("curved-walk.bvh");
      await expect(app.toast).toContainText("Your stored edits of this clip were applied.");
      await app.toast.getByRole("button", { name: "Show" }).click();
      await expect(page.getByRole("tabpanel", { name: "Labels" })).toBeVisible();
      await expect(app.toast).toBeHidden();
    });
  });
});
