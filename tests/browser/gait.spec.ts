/** How a person walks, in the Clip tab. */

import { expect, test } from "./app";

test("a walk has its cadence, times and lengths, left beside right", async ({ app }) => {
  await app.sample("curved-walk");
  await app.tab("Clip");
  const table = app.panel.getByRole("table", { name: "Gait" });
  await expect(table.getByRole("row", { name: /^Step length/ })).toHaveText(
    /6\d cm\s*(6\d|7\d) cm/,
  );
  await expect(table.getByRole("row", { name: /^Step width/ })).toHaveText(/1\d cm\s*1\d cm/);
  const cadence = Number.parseFloat(await app.fact("Cadence").innerText());
  expect(Math.abs(cadence - 112)).toBeLessThan(4);
  await expect(app.fact("Double support")).toContainText("% of a stride");
});

test("a limp leans to one side, and a run has flight", async ({ app }) => {
  await app.sample("limp-to-run");
  await app.tab("Clip");
  await expect(app.fact("Stance, right vs. left")).toHaveText(/^\d+ % longer$/);
  await expect(app.fact("Flight")).toContainText("% of a stride");
});

test("edits change the measures, and jumps have none", async ({ app, page }) => {
  await app.sample("curved-walk");
  await app.tab("Clip");
  const stance = app.panel.getByRole("row", { name: /^Stance/ });
  const before = await stance.innerText();
  // The first plant of the right foot, which is a whole one.
  for (let i = 0; i < 90; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("e");
  for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("o");
  await expect(stance).not.toHaveText(before);
  await app.sample("frog-jumps");
  await app.tab("Clip");
  await expect(app.panel.getByRole("heading", { name: "Foot joints" })).toBeVisible();
  await expect(app.panel.getByRole("heading", { name: "Gait" })).toBeHidden();
});
