/** The page counts frames from 0, and the first and the last frame are part of a plant. */

import { type App, expect, test } from "./app";
import { readLabels } from "./labels";
import { atEachSize } from "./viewports";

const field = (app: App, name: "First" | "Last") =>
  app.panel.getByRole("spinbutton", { name: `${name} frame` });

/** Returns how many pixels of the view have the colour of the left foot. */
async function leftPixels(app: App): Promise<number> {
  const picture = await app.stillPicture();
  return app.page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const ctx = new OffscreenCanvas(image.width, image.height).getContext("2d");
    if (!ctx) return 0;
    ctx.drawImage(image, 0, 0);
    const pixels = ctx.getImageData(0, 0, image.width, image.height).data;
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      const [r = 0, g = 0, b = 0] = pixels.subarray(i, i + 3);
      if (b - r > 90 && b > g) count++;
    }
    return count;
  }, picture);
}

atEachSize(() => {
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

  test("the counter, the view and edits have the same frames", async ({ app, page }) => {
    await app.openSample("curved-walk");
    await test.step("the counter ends at the last frame", async () => {
      await expect(page.locator(".frame-count")).toHaveText("frame 0 / 244");
      await page.keyboard.press("End");
      await expect(page.locator(".frame-count")).toHaveText("frame 244 / 244");
    });
    await test.step("the view lights a foot up to the last frame of its plant", async () => {
      const { left } = readLabels(await app.save("Labels"));
      const [plant] = left.contact ?? [];
      if (!plant) throw new Error("There is no plant.");
      await page.keyboard.press("Home");
      await page.keyboard.press("5");
      for (let i = 0; i < plant.end - 2; i++) await page.keyboard.press("ArrowRight");
      expect(await app.frame()).toBe(plant.end - 2);
      const inside = await leftPixels(app);
      await page.keyboard.press("ArrowRight");
      const last = await leftPixels(app);
      await page.keyboard.press("ArrowRight");
      const after = await leftPixels(app);
      // The outline of the footprint remains.
      expect(last).toBeGreaterThan(0.9 * inside);
      expect(after).toBeLessThan(0.75 * last);
    });
    await test.step("joining the halves of a split restores the plant", async () => {
      const before = readLabels(await app.save("Labels"));
      await page.keyboard.press("Home");
      for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowRight");
      await page.keyboard.press("e");
      await page.keyboard.press("b");
      await expect
        .poll(async () => readLabels(await app.save("Labels")).left.contact?.length)
        .toBe(4);
      await page.keyboard.press("Home");
      await page.keyboard.press("e");
      await page.keyboard.press("m");
      await expect.poll(async () => readLabels(await app.save("Labels"))).toEqual(before);
    });
  });
});
