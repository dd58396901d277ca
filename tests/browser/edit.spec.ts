/** Correcting labels by hand: by drag, by key, by button; taken back, kept, and saved. */

import { type App, expect, test } from "./app";
import { type Labels, readLabels } from "./labels";

const saved = async (app: App) => readLabels(await app.save("Labels"));
const contact = (labels: Labels, side: "left" | "right" = "left") => labels[side].contact ?? [];
const spans = (labels: Labels) => contact(labels).map(({ start, end }) => [start, end]);

/** The middle of the left foot's contact lane, at a frame. */
async function onLane(app: App, frame: number) {
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

const field = (app: App, name: "Start" | "End") =>
  app.panel.getByRole("spinbutton", { name: `${name} frame` });

test("an edge is dragged, taken back and done again", async ({ app, page }) => {
  await app.sample("curved-walk");
  const before = await saved(app);
  const [, second] = contact(before);
  if (!second) throw new Error("There is no second plant.");
  const from = await onLane(app, second.end);
  const to = await onLane(app, second.end + 12);
  await page.mouse.move(from.x - 1, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, to.y, { steps: 3 });
  await page.mouse.move(to.x - 1, to.y, { steps: 3 });
  // What is on show is the frame at the edge.
  await expect.poll(() => app.frame()).toBeGreaterThan(second.end + 6);
  await page.mouse.up();
  await expect(field(app, "Start")).toHaveValue(String(second.start));
  const end = Number(await field(app, "End").inputValue());
  expect(Math.abs(end - second.end - 12)).toBeLessThanOrEqual(1);
  const after = await saved(app);
  expect(spans(after)[1]).toEqual([second.start, end]);
  expect(contact(after).map(({ source }) => source)).toEqual(["auto", "edited", "auto"]);
  await page.keyboard.press("Control+z");
  await expect(field(app, "End")).toHaveValue(String(second.end));
  expect(await saved(app)).toEqual(before);
  await page.keyboard.press("Control+Shift+z");
  await expect(field(app, "End")).toHaveValue(String(end));
  expect(await saved(app)).toEqual(after);
});

test("everything goes by keyboard alone", async ({ app, page }) => {
  await app.sample("curved-walk");
  const [first, second, third] = spans(await saved(app));
  if (!first || !second || !third) throw new Error("There are three plants.");
  const [start = 0, end = 0] = second;
  await toFrame(app, start + 5);
  await page.keyboard.press("e");
  await page.keyboard.press("i");
  await expect(field(app, "Start")).toHaveValue(String(start + 5));
  for (let i = 0; i < 15; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("k");
  expect(spans(await saved(app))).toEqual([
    first,
    [start + 5, start + 20],
    [start + 21, end],
    third,
  ]);
  // The longer half is selected, and it cannot end before it starts.
  await page.keyboard.press("o");
  await expect(field(app, "End")).toHaveValue(String(end));
  await page.keyboard.press("Delete");
  expect(spans(await saved(app))).toEqual([first, [start + 5, start + 20], third]);
  await toFrame(app, start + 10);
  await page.keyboard.press("e");
  await page.keyboard.press("m");
  expect(spans(await saved(app))).toEqual([first, [start + 5, third[1]]]);
  await page.keyboard.press("Escape");
  await expect(field(app, "Start")).toBeHidden();
  await page.keyboard.press("Home");
  for (let i = 0; i < 5; i++) await page.keyboard.press("Control+z");
  expect(spans(await saved(app))).toEqual([first, second, third]);
});

test("everything goes by buttons and fields", async ({ app, page }) => {
  await app.sample("curved-walk");
  const before = await saved(app);
  const [first, second] = spans(before);
  if (!first || !second) throw new Error("There are two plants.");
  await app.panel.getByRole("button", { name: /^3 ?Left/ }).click();
  await expect(app.panel.getByText("Left contact, plant 3")).toBeVisible();
  await field(app, "End").fill(String((second[1] ?? 0) - 10));
  await field(app, "End").press("Tab");
  await expect(app.panel.getByText("edited").first()).toBeVisible();
  await app.panel.getByRole("button", { name: "Revert", exact: true }).click();
  await expect(field(app, "End")).toHaveValue(String(second[1]));
  expect(await saved(app)).toEqual(before);
  // Between the first plant and the second one there is room for another.
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

test("edits survive another method, another clip and a reload", async ({ app, page }) => {
  await app.sample("curved-walk");
  const [, second] = spans(await saved(app));
  if (!second) throw new Error("There are two plants.");
  const [start = 0, end = 0] = second;
  await toFrame(app, start + 9);
  await page.keyboard.press("e");
  await page.keyboard.press("i");
  const mine = [start + 9, end];
  expect(spans(await saved(app))).toContainEqual(mine);
  await app.tab("Detect");
  await page.getByRole("combobox", { name: "Method" }).selectOption("min-speed");
  await expect.poll(async () => (await saved(app)).method.name).toBe("min-speed");
  expect(spans(await saved(app))).toContainEqual(mine);
  await app.sample("frog-jumps");
  expect(contact(await saved(app)).some(({ source }) => source === "edited")).toBe(false);
  await app.sample("curved-walk");
  await page.reload();
  await app.opened("curved-walk.bvh");
  await expect.poll(async () => spans(await saved(app))).toContainEqual(mine);
  await expect(app.panel.getByText("edited")).toHaveCount(1);
});

test("labels of someone else become one's own, and are saved as edited", async ({ app }) => {
  await app.sample("curved-walk");
  const labels = await saved(app);
  const theirs = labels.left.contact?.map(({ start, end }) => [start + 3, end - 3] as const) ?? [];
  const none = Array.from({ length: labels.frames }, () => 0);
  const left = none.map((_, i) => Number(theirs.some(([from, to]) => i >= from && i < to)));
  await app.drop({
    name: "theirs.json",
    mimeType: "application/json",
    buffer: Buffer.from(JSON.stringify({ left, right: none })),
  });
  await app.panel.getByRole("button", { name: "Adopt reference labels" }).click();
  const mine = await saved(app);
  expect(spans(mine)).toEqual(theirs);
  expect(contact(mine, "right")).toEqual([]);
  expect(contact(mine).every(({ source }) => source === "edited")).toBe(true);
  // What is exported comes in again as it was.
  await app.tab("Score");
  await expect(app.panel.getByRole("row", { name: /^0.0 s/ })).toContainText("100.0");
});

test("full storage is said, and edits last as long as the page", async ({ app, page }) => {
  await app.page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await app.sample("curved-walk");
  const [, second] = spans(await saved(app));
  await toFrame(app, (second?.[0] ?? 0) + 4);
  await page.keyboard.press("e");
  await page.keyboard.press("i");
  await expect(app.panel.getByText("The storage of this browser is full")).toBeVisible();
  expect(spans(await saved(app))[1]?.[0]).toBe((second?.[0] ?? 0) + 4);
});

test("names of actions are kept with the clip", async ({ app, page }) => {
  await app.sample("limp-to-run");
  await app.segments();
  await app.panel.getByRole("textbox", { name: "Name of segment 2" }).fill("run");
  await app.sample("bowling");
  await app.sample("limp-to-run");
  await page.reload();
  await app.opened("limp-to-run.bvh");
  await app.tab("Segment");
  await expect(app.panel.getByRole("textbox", { name: "Name of segment 2" })).toHaveValue("run");
});
