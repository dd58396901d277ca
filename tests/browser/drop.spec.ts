import { join } from "node:path";
import type { JSHandle } from "@playwright/test";
import { type App, expect, test } from "./app";
import { clip, good, root, sample } from "./clips";

const highlight = (app: App) => app.page.getByText("Drop to open");

/** Returns a function that dispatches a drag event on an element. */
const dispatchDrag =
  (app: App, type: "dragenter" | "dragleave", at: "main" | "button" | "heading") =>
  async (dataTransfer: JSHandle<DataTransfer>) =>
    app.page.getByRole(at).first().dispatchEvent(type, { dataTransfer });

test("highlights the page while files are dragged over it", async ({ app }) => {
  await app.openStartPage();
  const files = await app.transfer(good("plain"));
  await dispatchDrag(app, "dragenter", "main")(files);
  await expect(highlight(app)).toBeVisible();
  await dispatchDrag(app, "dragleave", "main")(files);
  await expect(highlight(app)).toBeHidden();
});

test("does not remove the highlight while files move between elements", async ({ app }) => {
  await app.openStartPage();
  const files = await app.transfer(good("plain"));
  await dispatchDrag(app, "dragenter", "main")(files);
  for (const [from, to] of [
    ["main", "heading"],
    ["heading", "button"],
    ["button", "main"],
  ] as const) {
    await dispatchDrag(app, "dragenter", to)(files);
    await dispatchDrag(app, "dragleave", from)(files);
    await expect(highlight(app)).toBeVisible();
  }
  await dispatchDrag(app, "dragleave", "main")(files);
  await expect(highlight(app)).toBeHidden();
});

test("removes the highlight when files are dropped", async ({ app }) => {
  await app.openStartPage();
  const file = good("plain");
  await dispatchDrag(app, "dragenter", "main")(await app.transfer(file));
  await expect(highlight(app)).toBeVisible();
  await app.drop(file);
  await expect(highlight(app)).toBeHidden();
  await app.waitForClip(file.name);
});

test("ignores dragged text", async ({ app, page }) => {
  await app.openStartPage();
  const text = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    transfer.setData("text/plain", "HIERARCHY");
    return transfer;
  });
  await dispatchDrag(app, "dragenter", "main")(text);
  await expect(highlight(app)).toBeHidden();
});

test("opens a file dragged from the system", async ({ app, page }) => {
  await app.openStartPage();
  const system = await page.context().newCDPSession(page);
  const path = "tests/files/good/plain.bvh";
  const data = { items: [], files: [join(root, path)], dragOperationsMask: 1 };
  const drag = (type: "dragEnter" | "dragOver" | "drop", x: number, y: number) =>
    system.send("Input.dispatchDragEvent", { type, x, y, data });
  await drag("dragEnter", 300, 300);
  for (const [x, y] of [
    [700, 120],
    [720, 450],
    [400, 800],
    [60, 20],
  ] as const) {
    await drag("dragOver", x, y);
    await expect(highlight(app)).toBeVisible();
  }
  await drag("dragOver", -10, 20);
  await expect(highlight(app)).toBeHidden();
  await drag("dragEnter", 700, 450);
  await drag("dragOver", 705, 455);
  await expect(highlight(app)).toBeVisible();
  await drag("drop", 705, 455);
  await app.waitForClip(clip(path).name);
  await expect(highlight(app)).toBeHidden();
});

test("dialogs, menus and the tour do not cover what is dropped", async ({ app, page }) => {
  const table = page.getByRole("region", { name: "2 clips" });
  await app.openFile(sample("curved-walk"));
  await test.step("a dialog is closed by a table", async () => {
    await app.openShareDialog();
    await app.drop(sample("bowling"), sample("frog-jumps"));
    await expect(table).toBeFocused();
    await expect(app.dialog).toBeHidden();
  });
  await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
  await test.step("a dialog is closed by labels", async () => {
    await app.openShareDialog();
    await app.drop(clip("samples/curved-walk.json"));
    await expect(page.getByRole("tabpanel", { name: "Score" })).toBeVisible();
    await expect(app.dialog).toBeHidden();
  });
  await test.step("a dialog is closed by an error", async () => {
    await app.openShareDialog();
    await app.drop(clip("samples/index.json"));
    await expect(app.alert).toBeVisible();
    await expect(app.dialog).toBeHidden();
    await app.alert.getByRole("button", { name: "Dismiss" }).click();
  });
  await test.step("a dialog is closed when Forward leads to the table", async () => {
    await page.keyboard.press("?");
    await expect(app.dialog).toBeVisible();
    await page.goForward();
    await expect(table).toBeFocused();
    await expect(app.dialog).toBeHidden();
    await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
  });
  await test.step("a menu is closed by a table", async () => {
    const tracks = app.timeline.getByRole("button", { name: /^Tracks/ });
    await tracks.click();
    await expect(tracks).toHaveAttribute("aria-expanded", "true");
    await app.drop(sample("bowling"), sample("frog-jumps"));
    await expect(table).toBeFocused();
    await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
    await expect(tracks).toHaveAttribute("aria-expanded", "false");
  });
  await test.step("the table hides the tour", async () => {
    await page.keyboard.press("?");
    await app.dialog.getByRole("button", { name: "Show the tour" }).click();
    const tour = page.getByRole("complementary", { name: "Tour" });
    await expect(tour).toBeVisible();
    await app.head.getByRole("button", { name: "2 clips" }).click();
    await expect(table).toBeFocused();
    await expect(tour).toBeHidden();
    await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
    await expect(tour).toBeVisible();
  });
});
