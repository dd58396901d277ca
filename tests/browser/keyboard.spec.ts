import { expect, test } from "./app";
import { good, sample } from "./clips";

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

test("in the table, C marks the row that has the focus", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(sample("one-leg-hop"), sample("curved-walk"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await page.getByRole("button", { name: "curved-walk.bvh", exact: true }).click();
  await app.waitForClip("curved-walk.bvh");
  await app.head.getByRole("button", { name: "2 clips" }).click();
  await expect(page.getByRole("region", { name: "2 clips" })).toBeFocused();
  const isChecked = (name: string) =>
    page.getByRole("checkbox", { name: `${name}.bvh is checked` });
  // No row has the focus.
  await page.keyboard.press("c");
  await page.getByRole("button", { name: "one-leg-hop.bvh", exact: true }).focus();
  await page.keyboard.press("c");
  await expect(isChecked("one-leg-hop")).toBeChecked();
  await expect(isChecked("curved-walk")).not.toBeChecked();
  await page.keyboard.press("c");
  await expect(isChecked("one-leg-hop")).not.toBeChecked();
});

test("keys scroll the table", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(...Array.from({ length: 60 }, (_, i) => ({ ...good("plain"), name: `${i}.bvh` })));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  const scroller = page.locator(".batch-scroll");
  const scrollTop = () => scroller.evaluate((element) => element.scrollTop);
  await scroller.focus();
  await page.keyboard.press("End");
  await expect.poll(scrollTop).toBeGreaterThan(1000);
  await page.keyboard.press("Home");
  await expect.poll(scrollTop).toBe(0);
  await page.keyboard.press(" ");
  await expect.poll(scrollTop).toBeGreaterThan(100);
});

test("in the table, Ctrl+S saves all clips", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.drop(sample("one-leg-hop"), sample("bowling"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  const press = () => app.download(() => page.keyboard.press("Control+s"));
  expect((await press()).name).toBe("labels.zip");
  // The dialog is about the open clip.
  await app.openShareDialog();
  expect((await press()).name).toBe("curved-walk.plants.json");
});

test("keys do not change a clip that the table covers", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(sample("one-leg-hop"), sample("curved-walk"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await page.getByRole("button", { name: "curved-walk.bvh", exact: true }).click();
  await app.waitForClip("curved-walk.bvh");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect(page.locator(".message")).toHaveText("Plant deleted");
  const before = (await app.result("Left")).plants;
  await page.keyboard.press("e");
  const table = app.head.getByRole("button", { name: "2 clips" });
  await table.click();
  await expect(page.getByRole("region", { name: "2 clips" })).toBeFocused();
  for (const key of ["Delete", "x", "Control+z", " "]) await page.keyboard.press(key);
  const filter = page.getByRole("searchbox");
  await filter.fill("walk");
  await filter.press("Control+z");
  await expect(filter).not.toHaveValue("walk");
  await filter.fill("");
  // The clip is not in the order of the focus either.
  for (let i = 0; i < 40; i++) {
    await page.keyboard.press("Tab");
    expect(
      await page.evaluate(() => document.activeElement?.closest(".views, .timeline, .panel")),
    ).toBeNull();
  }
  await table.click();
  await expect(app.panel).toBeVisible();
  expect((await app.result("Left")).plants).toBe(before);
  await app.tab("Segment");
  await expect(app.panel).not.toContainText("Remove cut");
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await app.result("Left")).plants).toBe(before + 1);
});
