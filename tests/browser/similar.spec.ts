/** Applying an edit to similar plants: offered, shown, accepted, declined and undone. */

import { type App, expect, test } from "./app";
import { readLabels } from "./labels";
import { editBar, overlap } from "./touch-targets";
import { onPhones, viewports } from "./viewports";

const plants = async (app: App) => {
  const { left, right } = readLabels(await app.save("Labels"));
  return [...(left.contact ?? []), ...(right.contact ?? [])].map(({ start, end }) => [start, end]);
};

const offer = (app: App) => app.timeline.getByText(/similar plants? would change/);

async function toFrame(app: App, frame: number) {
  await app.playhead.focus();
  await app.page.keyboard.press("Home");
  for (let i = 0; i < frame; i++) await app.page.keyboard.press("ArrowRight");
  expect(await app.frame()).toBe(frame);
}

/** Moves the end of a plant in the middle of the clip by some frames. */
async function moveEnd(app: App, by: number): Promise<number> {
  const labels = readLabels(await app.save("Labels"));
  const plant = labels.left.contact?.[9];
  if (!plant) throw new Error("There is no tenth plant.");
  const { page } = app;
  await app.playhead.focus();
  await toFrame(app, plant.start + 1);
  await page.keyboard.press("e");
  const last = app.panel.getByRole("spinbutton", { name: "Last frame" });
  await last.fill(String(plant.end - 1 + by));
  await last.press("Enter");
  return plant.end + by;
}

test("applies an edit to similar plants, as one step", async ({ app, page }) => {
  await app.openSample("straight-jog");
  const before = await plants(app);
  await moveEnd(app, -3);
  await expect(offer(app)).toBeVisible();
  const edited = await plants(app);
  // The offer changes nothing.
  expect(edited.filter((plant, i) => String(plant) !== String(before[i]))).toHaveLength(1);
  await app.playhead.focus();
  await page.keyboard.press("y");
  await expect(offer(app)).toBeHidden();
  const after = await plants(app);
  const moved = after.filter(([, end = 0], i) => end < (before[i]?.[1] ?? 0));
  expect(moved.length).toBeGreaterThan(before.length / 2);
  await page.keyboard.press("Control+z");
  expect(await plants(app)).toEqual(edited);
  await expect(offer(app)).toBeVisible();
  await page.keyboard.press("Control+z");
  expect(await plants(app)).toEqual(before);
  await expect(offer(app)).toBeHidden();
});

test("retains the instants between frames, also in storage", async ({ app, page }) => {
  await app.openSample("straight-jog");
  const events = async () => (await app.save("Gait events")).text.trim().split("\n").slice(1);
  const detected = await events();
  // Only instants between frames have an uncertainty.
  const known = (rows: string[]) => rows.filter((row) => !row.endsWith(",")).length;
  expect(known(detected)).toBeGreaterThan(60);
  await moveEnd(app, -3);
  await expect(offer(app)).toBeVisible();
  await app.playhead.focus();
  await page.keyboard.press("y");
  await expect(offer(app)).toBeHidden();
  const accepted = await events();
  expect(accepted.filter((row) => !detected.includes(row)).length).toBeGreaterThan(10);
  // Both ends of the plant that was edited are known to the frame.
  expect(known(accepted)).toBeGreaterThanOrEqual(known(detected) - 2);
  await page.reload();
  await app.waitForClip("straight-jog.bvh");
  await expect(app.head.getByRole("button", { name: "edited" })).toBeVisible();
  expect(await events()).toEqual(accepted);
});

test("leaves similar plants as they are", async ({ app, page }) => {
  await app.openSample("straight-jog");
  await moveEnd(app, -3);
  await expect(offer(app)).toBeVisible();
  const edited = await plants(app);
  await app.timeline.getByRole("button", { name: "Leave similar plants as they are" }).click();
  await expect(offer(app)).toBeHidden();
  expect(await plants(app)).toEqual(edited);
  // Also on the next visit, once the stored edits are applied.
  await page.reload();
  await app.waitForClip("straight-jog.bvh");
  await expect(app.toast).toContainText("Your stored edits");
  await expect.poll(() => plants(app)).toEqual(edited);
  await expect(offer(app)).toBeHidden();
  // The next edit is offered again.
  await moveEnd(app, -1);
  await expect(offer(app)).toBeVisible();
});

test("a declined offer stays declined while cuts are edited", async ({ app, page }) => {
  await app.openSample("straight-jog");
  const segments = (await app.segments()).length;
  await moveEnd(app, -3);
  await expect(offer(app)).toBeVisible();
  await app.timeline.getByRole("button", { name: "Leave similar plants as they are" }).click();
  await expect(offer(app)).toBeHidden();
  await toFrame(app, 12);
  await page.keyboard.press("x");
  await expect.poll(async () => (await app.segments()).length).toBe(segments + 1);
  // The worker answers after it has answered a search for similar plants, if there was one.
  await plants(app);
  await expect(offer(app)).toBeHidden();
  await app.playhead.focus();
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await app.segments()).length).toBe(segments);
  await plants(app);
  await expect(offer(app)).toBeHidden();
  await app.playhead.focus();
  await page.keyboard.press("Control+Shift+z");
  await expect.poll(async () => (await app.segments()).length).toBe(segments + 1);
  // Also on the next visit.
  await page.reload();
  await app.waitForClip("straight-jog.bvh");
  await expect(app.toast).toContainText("Your stored edits");
  await plants(app);
  await expect(offer(app)).toBeHidden();
  // A new edit of plants is offered.
  await moveEnd(app, -1);
  await expect(offer(app)).toBeVisible();
});

test("small edits are not offered for other plants", async ({ app }) => {
  await app.openSample("curved-walk");
  const labels = readLabels(await app.save("Labels"));
  const plant = labels.left.contact?.[1];
  if (!plant) throw new Error("There is no second plant.");
  await toFrame(app, plant.start + 1);
  await app.page.keyboard.press("e");
  const last = app.panel.getByRole("spinbutton", { name: "Last frame" });
  await last.fill(String(plant.end));
  await last.press("Enter");
  await expect.poll(() => plants(app)).toContainEqual([plant.start, plant.end + 1]);
  await expect(offer(app)).toBeHidden();
});

/** The controls of the transport. */
const controls = (app: App) => [
  app.timeline.getByRole("button", { name: "Play" }),
  app.timeline.locator(".position"),
  app.timeline.locator(".loop"),
  app.timeline.getByRole("combobox", { name: "Speed" }),
  app.timeline.getByRole("button", { name: "Tracks" }),
  app.timeline.getByRole("button", { name: "Fit" }),
];

for (const [name, viewport] of Object.entries(viewports)) {
  test(`the offer fits on a page of the size ${name}`, async ({ app, page }) => {
    await page.setViewportSize(viewport);
    await app.openSample("straight-jog");
    await moveEnd(app, -3);
    await expect(offer(app)).toBeVisible();
    const element = app.timeline.locator(".similar-offer");
    const box = await element.boundingBox();
    expect(box && box.x >= 0 && box.x + box.width <= viewport.width && box.y > 0).toBe(true);
    for (const other of [app.stage, app.tracks, ...controls(app)]) {
      expect(await overlap(element, other)).toBe(0);
      await expect(other).toBeInViewport({ ratio: 1 });
    }
    // On the next visit, a notice about the stored edits appears, too, until the user works on the labels.
    await page.reload();
    await app.waitForClip("straight-jog.bvh");
    await expect(app.toast).toContainText("Your stored edits");
    await expect(offer(app)).toBeVisible();
    const pills = [app.view.locator(".pill.left"), app.view.locator(".pill.right")];
    for (const other of [element, app.tracks, ...controls(app), ...pills])
      expect(await overlap(app.toast, other)).toBe(0);
    await expect(app.toast).toBeInViewport({ ratio: 1 });
    await app.playhead.focus();
    await page.keyboard.press("e");
    await expect(app.toast).toBeHidden();
    await app.timeline.getByRole("button", { name: "Apply", exact: true }).click();
    await expect(offer(app)).toBeHidden();
  });
}

onPhones(() => {
  test("the offer leaves the view, the tracks and the play button uncovered", async ({ app }) => {
    await app.openSample("straight-jog");
    await moveEnd(app, -3);
    const lower = app.page.getByRole("button", { name: "Collapse panel" });
    if (await lower.isVisible()) await lower.tap();
    await editBar(app).getByRole("button", { name: "Last frame later" }).tap();
    await expect(offer(app)).toBeVisible();
    const message = app.page.locator(".message");
    await expect(message).toBeVisible();
    const box = app.timeline.locator(".similar-offer");
    for (const other of [app.tracks, app.stage, ...controls(app)]) {
      expect(await overlap(box, other)).toBe(0);
      await expect(other).toBeInViewport({ ratio: 1 });
    }
    const view = await app.stage.boundingBox();
    if (!view) throw new Error("There is no view.");
    // The character is in the middle of the view.
    const middle = view.x + view.width / 2;
    const bar = await editBar(app).boundingBox();
    expect((bar?.x ?? 0) + (bar?.width ?? 0)).toBeLessThan(middle - 10);
    expect((await message.boundingBox())?.y).toBeGreaterThan(view.y + 0.7 * view.height);
    const covered =
      (await overlap(box, app.stage)) +
      (await overlap(editBar(app), app.stage)) +
      (await overlap(message, app.stage));
    expect(covered).toBeLessThan((view.width * view.height) / 3);
    await app.timeline.getByRole("button", { name: "Apply", exact: true }).tap();
    await expect(offer(app)).toBeHidden();
  });
});
