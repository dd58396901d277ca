/** Gait measures in the Clip tab. */

import { expect, test } from "./app";

test("measures cadence, times and lengths of a walk", async ({ app }) => {
  await app.openSample("curved-walk");
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

test("measures asymmetry of a limp and flight of a run", async ({ app }) => {
  await app.openSample("limp-to-run");
  await app.tab("Clip");
  await expect(app.fact("Symmetry index, stance")).toHaveText(/^right \+\d+ %$/);
  await expect(app.fact("Flight")).toContainText("% of a stride");
});

test("updates gait measures after edits and shows none for jumps", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.tab("Clip");
  const stance = app.panel.getByRole("row", { name: /^Stance/ });
  const before = await stance.innerText();
  // The first complete plant of the right foot.
  for (let i = 0; i < 90; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("e");
  for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("o");
  await expect(stance).not.toHaveText(before);
  await app.openSample("frog-jumps");
  await app.tab("Clip");
  await expect(app.panel.getByRole("heading", { name: "Foot joints" })).toBeVisible();
  await expect(app.panel.getByRole("heading", { name: "Gait" })).toBeHidden();
});
