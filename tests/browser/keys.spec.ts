import { expect, test } from "./app";

test("1 to 4 turn the camera, as the buttons do", async ({ app, page }) => {
  await app.sample("curved-walk");
  for (const [i, name] of ["Perspective", "Front", "Side", "Top"].entries()) {
    await page.keyboard.press(String(i + 1));
    const pressed = app.view.getByRole("button", { name, pressed: true });
    await expect(pressed).toBeVisible();
  }
  await app.view.getByRole("button", { name: "Front" }).click();
  await expect(app.view.getByRole("button", { name: "Front", pressed: true })).toBeVisible();
  await expect(app.view.getByRole("button", { name: "Top", pressed: false })).toBeVisible();
});

test("a question mark lists the keys and Escape puts the list away", async ({ app, page }) => {
  await app.sample("curved-walk");
  await page.keyboard.press("?");
  await expect(app.dialog).toHaveAccessibleName("Keyboard shortcuts");
  await expect(app.dialog).toContainText("Previous, next plant edge");
  await page.keyboard.press("Escape");
  await expect(app.dialog).toBeHidden();
  await page.keyboard.press("ArrowRight");
  expect(await app.frame()).toBe(1);
});

test("the list of keys gives the focus back to the button that opened it", async ({
  app,
  page,
}) => {
  await app.empty();
  const button = app.head.getByRole("button", { name: "Keyboard shortcuts" });
  await button.focus();
  await page.keyboard.press("Enter");
  await expect(app.dialog).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(app.dialog).toBeHidden();
  await expect(button).toBeFocused();
});

test("Ctrl+O asks for a file", async ({ app, page }) => {
  // Waiting begins early: a key is faster than the browser's promise to tell of its dialogs.
  const choosing = page.waitForEvent("filechooser");
  await app.empty();
  await page.keyboard.press("Control+o");
  await choosing;
});

test("a slider that has the focus keeps its arrow keys", async ({ app, page }) => {
  await app.sample("curved-walk");
  await page.getByRole("slider", { name: /window/i }).focus();
  await page.keyboard.press("ArrowRight");
  await expect(page.getByRole("slider", { name: /window/i })).toHaveValue("2");
  expect(await app.frame()).toBe(0);
});

test("tabs are chosen by the arrow keys", async ({ app, page }) => {
  await app.sample("curved-walk");
  await page.getByRole("tab", { name: "Detect" }).focus();
  for (const name of ["Evidence", "Segment", "Labels", "Clip", "Detect"]) {
    await page.keyboard.press("ArrowRight");
    await expect(page.getByRole("tab", { name })).toBeFocused();
    await expect(page.getByRole("tabpanel", { name })).toBeVisible();
  }
});

test("the theme button goes from the system's to light to dark and is remembered", async ({
  app,
  page,
}) => {
  await app.empty();
  await app.head.getByRole("button", { name: "Theme: system" }).click();
  // A page that is left while its picture comes complains.
  const picture = page.waitForResponse(/-dark-.*\.webp$/);
  await app.head.getByRole("button", { name: "Theme: light" }).click();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await (await picture).finished();
  await page.reload();
  await expect(app.head.getByRole("button", { name: "Theme: dark" })).toBeVisible();
});
