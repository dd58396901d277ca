/** Measuring and removing foot skate. */

import { expect, test } from "./app";
import { file, sample } from "./clips";

test("measures and removes foot skate and saves the cleaned clip", async ({ app }) => {
  await app.openSample("limp-to-run");
  await app.tab("Clip");
  const table = app.panel.getByRole("table", { name: "Foot skate" });
  const slide = async (name: string) => {
    const cells = await table.getByRole("row", { name }).getByRole("cell").allInnerTexts();
    return cells.map(Number.parseFloat);
  };
  await expect.poll(async () => (await slide("Original"))[0] ?? 0).toBeGreaterThan(0.2);
  const [mean = 0, worst = 0] = await slide("Original");
  expect(worst).toBeGreaterThan(mean);
  await app.panel.getByRole("button", { name: "Fix foot skate" }).click();
  await expect(table.getByRole("row", { name: "Cleaned" })).toHaveText(/0\.0 cm\s*0\.0 cm/);
  await expect(app.panel.getByRole("button", { name: "Both" })).toHaveAttribute(
    "aria-pressed",
    "true",
  );
  const both = await app.stillPicture();
  await app.panel.getByRole("button", { name: "Cleaned", exact: true }).click();
  await expect.poll(async () => (await app.picture()) === both).toBe(false);
  const saved = await app.download(() =>
    app.panel.getByRole("button", { name: /^Save cleaned clip/ }).click(),
  );
  expect(saved.name).toBe("limp-to-run.clean.bvh");
  const labels = await app.save("Labels");
  // The saved clip has almost no foot skate under the original labels.
  await app.drop(file(saved.name, saved.text));
  await app.waitForClip("limp-to-run.clean.bvh");
  await app.drop(file(labels.name, labels.text));
  await app.panel.getByRole("button", { name: "Use these labels" }).click();
  await app.tab("Clip");
  // The heel position is estimated again from the saved clip, which changes slides by a millimetre.
  await expect.poll(async () => (await slide("Original"))[0]).toBeLessThan(mean / 8);
});

test("goes to the largest slide and discards the result after edits", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.tab("Clip");
  await app.panel.getByRole("button", { name: "Fix foot skate" }).click();
  await expect(app.panel.getByRole("button", { name: "Cleaned", exact: true })).toBeVisible();
  await page.keyboard.press("End");
  await app.panel.getByRole("button", { name: /^\d.* cm$/ }).click();
  expect(await app.frame()).toBeLessThan(244);
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect(app.panel.getByRole("button", { name: "Fix foot skate" })).toBeVisible();
});

test("repairs spikes of the hips and can leave them", async ({ app }) => {
  const lines = sample("curved-walk").buffer.toString().split("\n");
  const row = lines.findIndex((line) => line.startsWith("Frame Time")) + 1 + 81;
  const [x, y, ...others] = (lines[row] ?? "").split(" ");
  lines[row] = [x, Number(y) + 12, ...others].join(" ");
  await app.openFile(file("spike.bvh", lines.join("\n")));
  await app.tab("Clip");
  await app.panel.getByRole("button", { name: "Fix foot skate" }).click();
  const notice = app.panel.getByText(/^The hips have a spike, from frame 81 on/);
  await expect(notice).toBeVisible();
  const repair = app.panel.getByRole("checkbox", { name: "Repair spikes of the hips" });
  await repair.click();
  await expect(notice).toBeHidden();
  await expect(repair).not.toBeChecked();
  await expect(app.panel.getByRole("button", { name: "Cleaned", exact: true })).toBeVisible();
  await repair.click();
  await expect(notice).toBeVisible();
});
