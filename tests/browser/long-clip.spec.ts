import { expect, test } from "./app";
import { repeated, sample } from "./clips";

/** A clip with more plants than the timeline has pixels. */
const long = repeated(sample("curved-walk"), 122);

test("labels, plays and scrubs a clip of 30,000 frames", async ({ app, page }) => {
  test.slow();
  await app.openFile(long);
  expect(await app.lastFrame()).toBe(122 * 245 - 1);
  const left = await app.result("Left");
  expect(left.plants).toBeGreaterThan(200);
  expect(left.percent).toBeGreaterThan(20);

  // The timeline shows the entire clip, and a drag scrubs through it.
  const middle = await app.pressRuler(0.5);
  expect(middle).toBeGreaterThan(12_000);
  expect(middle).toBeLessThan(18_000);
  const { x, y } = await app.ruler(0.5);
  await page.mouse.move(x, y + 60);
  await page.mouse.move(x, y);
  await page.mouse.down();
  let before = middle;
  for (const position of [0.6, 0.75, 0.9]) {
    await page.mouse.move((await app.ruler(position)).x, y, { steps: 4 });
    await expect.poll(() => app.frame()).toBeGreaterThan(before);
    before = await app.frame();
  }
  await page.mouse.up();
  expect(before).toBeGreaterThan(24_000);

  // The text of the playhead agrees with the foot status in the view.
  await page.keyboard.press("Shift+ArrowRight");
  const words = (await app.playhead.getAttribute("aria-valuetext")) ?? "";
  for (const [foot, side] of [
    ["Left", "left"],
    ["Right", "right"],
  ] as const) {
    const state = words.includes(`${side} in contact`) ? "in contact" : "in the air";
    expect(words).toContain(`${side} ${state}`);
    await expect(app.view.getByText(`${foot} ${state}`)).toBeVisible();
  }

  // The table for screen readers is limited; the list is complete.
  await expect(
    app.timeline.getByRole("table", { name: /first 100 listed/ }).first(),
  ).toBeAttached();
  await app.tab("Labels");
  const rows = app.panel.getByRole("listitem");
  await expect(rows.first()).toHaveAttribute("aria-setsize", /^[4-9]\d\d$/);
  expect(await rows.count()).toBeLessThan(60);

  await page.keyboard.press("Home");
  await page.keyboard.press("Space");
  await expect.poll(() => app.frame()).toBeGreaterThan(30);
});
