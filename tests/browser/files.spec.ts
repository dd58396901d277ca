import { expect, test } from "./app";
import { bad, good, opens, refused } from "./clips";

test("the lists of files good and bad are read", () => {
  expect(opens.length).toBeGreaterThanOrEqual(10);
  expect(refused.length).toBeGreaterThanOrEqual(8);
});

for (const { name, place, message } of refused) {
  test(`${name} is refused in words, and the clip before stays`, async ({ app, page }) => {
    await app.with(good("plain"));
    await app.drop(bad(name));
    await expect(app.alert.getByRole("heading")).toHaveText(`${name}.bvh could not be opened`);
    // The page takes archives apart, whatever they are called; the reader does not.
    const said = name === "archive" ? "There is no BVH file in the archive" : message;
    await expect(app.alert).toContainText(said.replace(/\.$/, ""), { ignoreCase: true });
    if (place) {
      await expect(app.alert).toContainText(`At ${place}`);
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

test("the report of a refused file can be copied", async ({ app, page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await app.empty();
  await app.drop(bad("unknown-channel"));
  await app.alert.getByRole("button", { name: "Copy report" }).click();
  await expect(app.alert.getByRole("button", { name: "Copied" })).toBeVisible();
  const report = await page.evaluate(() => navigator.clipboard.readText());
  expect(report).toContain("unknown-channel.bvh");
  expect(report).toContain("line 5, column 53");
});

for (const { name, frames, notices } of opens) {
  test(`${name} opens with its ${frames} frames and notices`, async ({ app }) => {
    await app.with(good(name));
    if (frames) expect(await app.lastFrame()).toBe(frames - 1);
    else await expect(app.timeline).toContainText("no motion");
    if (!notices.length) return;
    await app.head.getByRole("button", { name: /^\d+ notices?$/ }).click();
    await expect(app.dialog).toHaveAccessibleName(`Notices on ${name}.bvh`);
    const said = await app.dialog.locator("code").allInnerTexts();
    expect(said).toEqual(expect.arrayContaining(notices));
    await app.page.keyboard.press("Escape");
    await expect(app.dialog).toBeHidden();
  });
}
