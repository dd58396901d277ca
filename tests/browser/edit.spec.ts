/** Editing labels by drag, by key and by button; undoing, storing and saving edits. */

import { type App, expect, test } from "./app";
import { type Labels, readLabels } from "./labels";

const saved = async (app: App) => readLabels(await app.save("Labels"));
const contact = (labels: Labels, side: "left" | "right" = "left") => labels[side].contact ?? [];
const spans = (labels: Labels) => contact(labels).map(({ start, end }) => [start, end]);

/** Returns the point on the contact track of the left foot at a frame. */
async function pointOnTrack(app: App, frame: number) {
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const [first, second] = [await app.pressRuler(0.5), await app.pressRuler(0.9)];
  const perFrame = (0.4 * box.width) / (second - first);
  return { x: box.x + 0.5 * box.width + (frame - first) * perFrame, y: box.y + 42 };
}

async function toFrame(app: App, frame: number) {
  const { page } = app;
  await page.keyboard.press("Home");
  for (let i = 0; i < frame; i++) await page.keyboard.press("ArrowRight");
  expect(await app.frame()).toBe(frame);
}

const field = (app: App, name: "First" | "Last") =>
  app.panel.getByRole("spinbutton", { name: `${name} frame` });

test("drags an edge, with undo and redo", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const before = await saved(app);
  const [, second] = contact(before);
  if (!second) throw new Error("There is no second plant.");
  const from = await pointOnTrack(app, second.end);
  const to = await pointOnTrack(app, second.end + 12);
  await page.mouse.move(from.x - 1, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, to.y, { steps: 3 });
  await page.mouse.move(to.x - 1, to.y, { steps: 3 });
  // The view shows the frame of the dragged edge.
  await expect.poll(() => app.frame()).toBeGreaterThan(second.end + 6);
  await page.mouse.up();
  await expect(field(app, "First")).toHaveValue(String(second.start));
  const end = Number(await field(app, "Last").inputValue()) + 1;
  expect(Math.abs(end - second.end - 12)).toBeLessThanOrEqual(1);
  const after = await saved(app);
  expect(spans(after)[1]).toEqual([second.start, end]);
  expect(contact(after).map(({ source }) => source)).toEqual(["auto", "edited", "auto"]);
  await page.keyboard.press("Control+z");
  await expect(field(app, "Last")).toHaveValue(String(second.end - 1));
  expect(await saved(app)).toEqual(before);
  await page.keyboard.press("Control+Shift+z");
  await expect(field(app, "Last")).toHaveValue(String(end - 1));
  expect(await saved(app)).toEqual(after);
});

test("edits plants by keyboard", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const [first, second, third] = spans(await saved(app));
  if (!first || !second || !third) throw new Error("There are three plants.");
  const [start = 0, end = 0] = second;
  await toFrame(app, start + 5);
  await page.keyboard.press("e");
  await page.keyboard.press("i");
  await expect(field(app, "First")).toHaveValue(String(start + 5));
  for (let i = 0; i < 15; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("b");
  expect(spans(await saved(app))).toEqual([
    first,
    [start + 5, start + 20],
    [start + 21, end],
    third,
  ]);
  // The longer half is selected; its end cannot be moved before its start.
  await page.keyboard.press("o");
  await expect(field(app, "Last")).toHaveValue(String(end - 1));
  await page.keyboard.press("Delete");
  expect(spans(await saved(app))).toEqual([first, [start + 5, start + 20], third]);
  await toFrame(app, start + 10);
  await page.keyboard.press("e");
  await page.keyboard.press("m");
  expect(spans(await saved(app))).toEqual([first, [start + 5, third[1]]]);
  await page.keyboard.press("Escape");
  await expect(field(app, "First")).toBeHidden();
  await page.keyboard.press("Home");
  for (let i = 0; i < 5; i++) await page.keyboard.press("Control+z");
  expect(spans(await saved(app))).toEqual([first, second, third]);
});

test("edits given faster than they are applied are done in order", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const before = spans(await saved(app));
  const [first, [start = 0, end = 0] = [], third] = before;
  await toFrame(app, start + 5);
  const typed = ["e", "i", ...Array<string>(15).fill("ArrowRight"), "b", "Delete"];
  const press = (keys: string[]) =>
    page.evaluate((pressed) => {
      // All in one task: the worker answers none of them before the last one.
      for (const combination of pressed) {
        const key = combination.replace("Control+", "");
        const init = { key, ctrlKey: key !== combination, bubbles: true };
        document.body.dispatchEvent(new KeyboardEvent("keydown", init));
      }
    }, keys);
  await press(typed);
  // The longer part of the split plant was deleted, which is the one after the playhead.
  expect(end - start).toBeGreaterThan(40);
  await expect
    .poll(async () => spans(await saved(app)))
    .toEqual([first, [start + 5, start + 20], third]);
  for (let i = 0; i < 3; i++) await page.keyboard.press("Control+z");
  await expect.poll(async () => spans(await saved(app))).toEqual(before);

  // Labels that are saved in the same task contain the edits before.
  await toFrame(app, start + 5);
  const labels = await app.download(() => press([...typed, "Control+s"]));
  expect(spans(readLabels(labels))).toEqual([first, [start + 5, start + 20], third]);
});

test("edits plants by buttons and fields", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const before = await saved(app);
  const [first, second] = spans(before);
  if (!first || !second) throw new Error("There are two plants.");
  await app.panel.getByRole("button", { name: /^3 ?Left/ }).click();
  await expect(app.panel.getByText("Left contact, plant 3")).toBeVisible();
  await field(app, "Last").fill(String((second[1] ?? 0) - 11));
  await field(app, "Last").press("Tab");
  await expect(app.panel.getByText("edited").first()).toBeVisible();
  await app.panel.getByRole("button", { name: "Revert", exact: true }).click();
  await expect(field(app, "Last")).toHaveValue(String((second[1] ?? 0) - 1));
  expect(await saved(app)).toEqual(before);
  // Another plant fits between the first and the second one.
  await toFrame(app, (first[1] ?? 0) + 10);
  await app.panel.getByRole("combobox", { name: "Part" }).selectOption("heel");
  await app.panel.getByRole("button", { name: "Add plant" }).click();
  const added = await saved(app);
  expect(contact(added)).toHaveLength(contact(before).length + 1);
  expect(added.left.heel).toHaveLength((before.left.heel?.length ?? 0) + 1);
  expect(added.left.toe).toEqual(before.left.toe);
  await app.panel.getByRole("button", { name: "Revert all" }).click();
  expect(await saved(app)).toEqual(before);
  await page.getByRole("button", { name: "Undo" }).click();
  expect(await saved(app)).toEqual(added);
});

test("preserves edits when the method or the clip changes and after a reload", async ({
  app,
  page,
}) => {
  await app.openSample("curved-walk");
  const [, second] = spans(await saved(app));
  if (!second) throw new Error("There are two plants.");
  const [start = 0, end = 0] = second;
  await toFrame(app, start + 9);
  await page.keyboard.press("e");
  await page.keyboard.press("i");
  const edited = [start + 9, end];
  expect(spans(await saved(app))).toContainEqual(edited);
  await app.tab("Detect");
  await page.getByRole("combobox", { name: "Method" }).selectOption("min-speed");
  await expect.poll(async () => (await saved(app)).method.name).toBe("min-speed");
  expect(spans(await saved(app))).toContainEqual(edited);
  await app.openSample("frog-jumps");
  expect(contact(await saved(app)).some(({ source }) => source === "edited")).toBe(false);
  await app.openSample("curved-walk");
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(async () => spans(await saved(app))).toContainEqual(edited);
  await expect(app.panel.getByText("edited")).toHaveCount(1);
});

test("adopts reference labels as edits", async ({ app }) => {
  await app.openSample("curved-walk");
  const labels = await saved(app);
  const reference =
    labels.left.contact?.map(({ start, end }) => [start + 3, end - 3] as const) ?? [];
  const none = Array.from({ length: labels.frames }, () => 0);
  const left = none.map((_, i) => Number(reference.some(([from, to]) => i >= from && i < to)));
  await app.drop({
    name: "reference.json",
    mimeType: "application/json",
    buffer: Buffer.from(JSON.stringify({ left, right: none })),
  });
  await app.panel.getByRole("button", { name: "Use these labels" }).click();
  const edited = await saved(app);
  expect(spans(edited)).toEqual(reference);
  expect(contact(edited, "right")).toEqual([]);
  expect(contact(edited).every(({ source }) => source === "edited")).toBe(true);
  // The adopted labels agree with the reference.
  await app.tab("Score");
  await expect(app.panel.getByRole("row", { name: /^0.0 s/ })).toContainText("100.0");
});

test("reports full storage and preserves edits until the page is closed", async ({ app, page }) => {
  await app.page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await app.openSample("curved-walk");
  const [, second] = spans(await saved(app));
  await toFrame(app, (second?.[0] ?? 0) + 4);
  await page.keyboard.press("e");
  await page.keyboard.press("i");
  await expect(app.panel.getByText("The storage of this browser is full")).toBeVisible();
  expect(spans(await saved(app))[1]?.[0]).toBe((second?.[0] ?? 0) + 4);
});

test("stores segment names with the clip", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.segments();
  await app.panel.getByRole("textbox", { name: "Name of segment 2" }).fill("run");
  await app.openSample("bowling");
  await app.openSample("limp-to-run");
  await page.reload();
  await app.waitForClip("limp-to-run.bvh");
  await app.tab("Segment");
  await expect(app.panel.getByRole("textbox", { name: "Name of segment 2" })).toHaveValue("run");
});
