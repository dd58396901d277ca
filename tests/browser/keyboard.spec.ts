import { expect, test } from "./app";

test("opens and closes the list of keyboard shortcuts", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await page.keyboard.press("?");
  await expect(app.dialog).toHaveAccessibleName("Keyboard shortcuts");
  await expect(app.dialog).toContainText("Previous, next plant edge");
  await page.keyboard.press("Escape");
  await expect(app.dialog).toBeHidden();
  await page.keyboard.press("ArrowRight");
  expect(await app.frame()).toBe(1);
});

test("returns the focus when the list of shortcuts is closed", async ({ app, page }) => {
  await app.openStartPage();
  const button = app.head.getByRole("button", { name: "Keyboard shortcuts" });
  await button.focus();
  await page.keyboard.press("Enter");
  await expect(app.dialog).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(app.dialog).toBeHidden();
  await expect(button).toBeFocused();
});

test("opens the file picker by Ctrl+O", async ({ app, page }) => {
  // Registered first, because the event may precede the end of the key press.
  const choosing = page.waitForEvent("filechooser");
  await app.openStartPage();
  await page.keyboard.press("Control+o");
  await choosing;
});

test("a focused slider handles arrow keys", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await page.getByRole("slider", { name: /window/i }).focus();
  await page.keyboard.press("ArrowRight");
  await expect(page.getByRole("slider", { name: /window/i })).toHaveValue("2");
  expect(await app.frame()).toBe(0);
});

test("selects tabs by arrow keys", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await page.getByRole("tab", { name: "Detect" }).focus();
  for (const name of ["Evidence", "Segment", "Labels", "Clip", "Detect"]) {
    await page.keyboard.press("ArrowRight");
    await expect(page.getByRole("tab", { name })).toBeFocused();
    await expect(page.getByRole("tabpanel", { name })).toBeVisible();
  }
});

test("cycles and stores the theme", async ({ app, page }) => {
  await app.openStartPage();
  await app.head.getByRole("button", { name: "Theme: system" }).click();
  // Reloading during the download of the picture would cause an error.
  const picture = page.waitForResponse(/-dark-.*\.webp$/);
  await app.head.getByRole("button", { name: "Theme: light" }).click();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await (await picture).finished();
  await page.reload();
  await expect(app.head.getByRole("button", { name: "Theme: dark" })).toBeVisible();
});
