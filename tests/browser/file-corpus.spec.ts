import { expect, test } from "./app";
import { bad, good, invalidFiles, validFiles } from "./clips";

test("reads the lists of valid and invalid files", () => {
  expect(validFiles.length).toBeGreaterThanOrEqual(10);
  expect(invalidFiles.length).toBeGreaterThanOrEqual(8);
});

test("reports invalid files and leaves the clip open", async ({ app, page }) => {
  await app.openFile(good("plain"));
  for (const { name, location, message } of invalidFiles) {
    await test.step(name, async () => {
      await app.drop(bad(name));
      await expect(app.alert.getByRole("heading")).toHaveText(`${name}.bvh could not be opened`);
      // The page unpacks archives whatever their names; the reader does not.
      const expected = name === "archive" ? "it is incomplete: it has no list of files" : message;
      await expect(app.alert).toContainText(expected.replace(/\.$/, ""), { ignoreCase: true });
      if (location) {
        await expect(app.alert).toContainText(`At ${location}`);
        await expect(app.alert.getByText(/\^$/)).toBeVisible();
      }
      await expect(app.alert).toContainText("plain.bvh is still open");
      await expect(page).toHaveTitle("plain.bvh – Plantigrade");
      await page.keyboard.press("End");
      expect(await app.frame()).toBe(11);
      await app.alert.getByRole("button", { name: "Dismiss" }).click();
      await expect(app.alert).toBeHidden();
      await expect(app.state).toHaveAttribute("data-state", "ready");
      expect(await app.pressRuler(0.2)).toBeLessThan(11);
    });
  }
});

test("copies the report of an invalid file", async ({ app, page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await app.openStartPage();
  await app.drop(bad("unknown-channel"));
  await app.alert.getByRole("button", { name: "Copy report" }).click();
  await expect(app.alert.getByRole("button", { name: "Copied" })).toBeVisible();
  const report = await page.evaluate(() => navigator.clipboard.readText());
  expect(report).toContain("unknown-channel.bvh");
  expect(report).toContain("line 5, column 53");
});

test("opens valid files with their frames and notices", async ({ app, page }) => {
  await app.openStartPage();
  for (const { name, frames, notices } of validFiles) {
    await test.step(name, async () => {
      await app.drop(good(name));
      await app.waitForClip(`${name}.bvh`);
      if (frames) expect(await app.lastFrame()).toBe(frames - 1);
      else await expect(app.timeline).toContainText("no motion");
      if (!notices.length) return;
      await app.head.getByRole("button", { name: /^\d+ notices?$/ }).click();
      await expect(app.dialog).toHaveAccessibleName(`Notices for ${name}.bvh`);
      const codes = await app.dialog.locator("code").allInnerTexts();
      expect(codes).toEqual(expect.arrayContaining(notices));
      await page.keyboard.press("Escape");
      await expect(app.dialog).toBeHidden();
    });
  }
});
