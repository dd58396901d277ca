import { join } from "node:path";
import type { JSHandle } from "@playwright/test";
import { type App, expect, test } from "./app";
import { clip, good, root } from "./clips";

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
