import { join } from "node:path";
import type { JSHandle } from "@playwright/test";
import { type App, expect, test } from "./app";
import { clip, good, root } from "./clips";

const highlight = (app: App) => app.page.getByText("Drop to open");

/** Tells an element of a drag that passes over it. */
const over =
  (app: App, type: "dragenter" | "dragleave", at: "main" | "button" | "heading") =>
  async (dataTransfer: JSHandle<DataTransfer>) =>
    app.page.getByRole(at).first().dispatchEvent(type, { dataTransfer });

test("files dragged over the page light it up until they leave", async ({ app }) => {
  await app.empty();
  const files = await app.transfer(good("plain"));
  await over(app, "dragenter", "main")(files);
  await expect(highlight(app)).toBeVisible();
  await over(app, "dragleave", "main")(files);
  await expect(highlight(app)).toBeHidden();
});

test("the light stays while files move from element to element", async ({ app }) => {
  await app.empty();
  const files = await app.transfer(good("plain"));
  await over(app, "dragenter", "main")(files);
  for (const [from, to] of [
    ["main", "heading"],
    ["heading", "button"],
    ["button", "main"],
  ] as const) {
    await over(app, "dragenter", to)(files);
    await over(app, "dragleave", from)(files);
    await expect(highlight(app)).toBeVisible();
  }
  await over(app, "dragleave", "main")(files);
  await expect(highlight(app)).toBeHidden();
});

test("the light goes out when files are dropped", async ({ app }) => {
  await app.empty();
  const file = good("plain");
  await over(app, "dragenter", "main")(await app.transfer(file));
  await expect(highlight(app)).toBeVisible();
  await app.drop(file);
  await expect(highlight(app)).toBeHidden();
  await app.opened(file.name);
});

test("dragged text is none of the page's business", async ({ app, page }) => {
  await app.empty();
  const text = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    transfer.setData("text/plain", "HIERARCHY");
    return transfer;
  });
  await over(app, "dragenter", "main")(text);
  await expect(highlight(app)).toBeHidden();
});

test("a file that the system drags across the page and drops opens", async ({ app, page }) => {
  await app.empty();
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
  await app.opened(clip(path).name);
  await expect(highlight(app)).toBeHidden();
});
