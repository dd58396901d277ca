/** The page counts frames from 0, and the first and the last frame are part of a plant. */

import { type App, expect, test } from "./app";
import { readLabels } from "./labels";

const field = (app: App, name: "First" | "Last") =>
  app.panel.getByRole("spinbutton", { name: `${name} frame` });

test("fields, keys, counter and messages agree", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const labels = readLabels(await app.save("Labels"));
  const [plant] = labels.left.contact ?? [];
  if (!plant) throw new Error("There is no plant.");
  await page.keyboard.press("e");
  const status = page.locator("p[role=status]");
  await expect(status).toHaveText(
    `left contact selected, frames ${plant.start} to ${plant.end - 1}`,
  );
  await expect(field(app, "First")).toHaveValue(String(plant.start));
  await expect(field(app, "Last")).toHaveValue(String(plant.end - 1));
  // The edge is the last frame of the plant, and O there changes nothing.
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  expect(await app.frame()).toBe(plant.end - 1);
  await page.keyboard.press("o");
  await expect(field(app, "Last")).toHaveValue(String(plant.end - 1));
  await expect(app.view.getByText("Left in contact")).toBeVisible();
  await page.keyboard.press("ArrowRight");
  await expect(app.view.getByText("Left in the air")).toBeVisible();
  await page.keyboard.press("o");
  await expect(field(app, "Last")).toHaveValue(String(plant.end));
  await expect(app.view.getByText("Left in contact")).toBeVisible();
  expect(readLabels(await app.save("Labels")).left.contact?.[0]?.end).toBe(plant.end + 1);
});

test("the counter ends at the last frame", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await expect(page.locator(".frame-count")).toHaveText("frame 0 / 244");
  await page.keyboard.press("End");
  await expect(page.locator(".frame-count")).toHaveText("frame 244 / 244");
});

test("joining the halves of a split restores the plant", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const before = readLabels(await app.save("Labels"));
  for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("e");
  await page.keyboard.press("b");
  await expect.poll(async () => readLabels(await app.save("Labels")).left.contact?.length).toBe(4);
  await page.keyboard.press("Home");
  await page.keyboard.press("e");
  await page.keyboard.press("m");
  await expect.poll(async () => readLabels(await app.save("Labels"))).toEqual(before);
});
