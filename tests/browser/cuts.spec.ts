/** Editing the cuts between segments, and naming actions. */

import { type App, expect, test } from "./app";

const frameRate = 24;
const frames = 744;

/** Returns the cuts of the list, in frames. */
async function cutsOf(app: App): Promise<number[]> {
  const segments = await app.segments();
  return segments.slice(1).map(({ start }) => Math.round(start * frameRate));
}

const expectCuts = (app: App, cuts: readonly number[]) =>
  expect.poll(() => cutsOf(app)).toEqual(cuts);

/** Returns the point on the segment lane at a cut, and the pixels per frame. */
async function pointAtCut(app: App, cut: number) {
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const [labelWidth, margin] = [118, 14];
  const perFrame = (box.width - labelWidth - margin) / frames;
  const x = box.x + labelWidth + cut * perFrame;
  const { page } = app;
  for (let y = box.y + box.height - 40; y > box.y + 150; y -= 3) {
    await page.mouse.move(x, y);
    const cursor = await app.tracks.evaluate((canvas) => (canvas as HTMLElement).style.cursor);
    if (cursor === "ew-resize") return { x, y: y - 4, perFrame };
  }
  throw new Error("No cut was hit.");
}

const field = (app: App) => app.panel.getByRole("spinbutton", { name: "Cut at frame" });

test("moves a cut by drag, key and number, with undo and redo", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const [first = 0, second = 0] = await cutsOf(app);
  const { x, y, perFrame } = await pointAtCut(app, first);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20 * perFrame, y, { steps: 4 });
  await page.mouse.up();
  await expect.poll(async () => (await cutsOf(app))[0]).toBeGreaterThan(first + 15);
  const dragged = (await cutsOf(app))[0] ?? 0;
  await expect(field(app)).toHaveValue(String(dragged));
  expect(await app.frame()).toBe(dragged);
  for (let i = 0; i < 3; i++) await page.keyboard.press("q");
  await expectCuts(app, [dragged - 3, second]);
  await field(app).fill("350");
  await page.keyboard.press("Enter");
  await expectCuts(app, [350, second]);
  // A cut stays between its neighbours.
  await field(app).fill("9999");
  await page.keyboard.press("Enter");
  await expectCuts(app, [second - 1, second]);
  for (let i = 0; i < 6; i++) await page.keyboard.press("Control+z");
  await expectCuts(app, [first, second]);
  await page.keyboard.press("Control+Shift+z");
  await expectCuts(app, [dragged, second]);
});

test("adds and removes cuts by keys and buttons, and stores them", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const [first = 0, second = 0] = await cutsOf(app);
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("x");
  await expectCuts(app, [5, first, second]);
  await page.keyboard.press("Delete");
  await expectCuts(app, [first, second]);
  await app.panel.getByRole("button", { name: "Add cut" }).click();
  await expectCuts(app, [5, first, second]);
  await page.keyboard.press("End");
  await page.keyboard.press("Escape");
  await app.panel.getByRole("button", { name: "Remove nearest cut" }).click();
  await expectCuts(app, [5, first]);
  await page.reload();
  await app.waitForClip("limp-to-run.bvh");
  await expectCuts(app, [5, first]);
  // Saved and read back, they agree with themselves.
  const saved = await app.saveSegments("Segments");
  expect(JSON.parse(saved.text).segments.map(({ start }: { start: number }) => start)).toEqual([
    0,
    5,
    first,
  ]);
  await app.drop({
    name: "limp-to-run.segments.json",
    mimeType: "application/json",
    buffer: Buffer.from(saved.text),
  });
  await expect(app.panel.getByRole("row", { name: /^± 0\.5 s/ })).toContainText("100");
});

test("edits of cuts and of plants share one history", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const cuts = await cutsOf(app);
  const { plants } = await app.result("Left");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  for (let i = 0; i < 9; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("x");
  await expectCuts(app, [9, ...cuts]);
  await page.keyboard.press("Control+z");
  await expectCuts(app, cuts);
  expect((await app.result("Left")).plants).toBe(plants - 1);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await app.result("Left")).plants).toBe(plants);
});

test("a name applies to all segments of the action, except named ones", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.segments();
  const name = (i: number) => app.panel.getByRole("textbox", { name: `Name of segment ${i}` });
  const button = (i: number) =>
    app.panel.getByRole("button", { name: new RegExp(`^Loop segment ${i},`) });
  await expect(button(1)).toHaveAccessibleName(/action A/);
  await expect(button(2)).toHaveAccessibleName(/action B/);
  await expect(button(3)).toHaveAccessibleName(/action A/);
  await name(1).fill("limp");
  await expect(name(3)).toHaveValue("limp");
  await expect(name(2)).toHaveValue("");
  await name(3).fill("slow limp");
  await expect(name(1)).toHaveValue("limp");
  await page.keyboard.press("Enter");
  const { segments } = JSON.parse((await app.saveSegments("Segments")).text);
  expect(segments.map(({ label }: { label: string }) => label)).toEqual(["limp", "", "slow limp"]);
});

test("an action retains its name when its segments are cut or joined", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const [first = 0, second = 0] = await cutsOf(app);
  const name = (i: number) => app.panel.getByRole("textbox", { name: `Name of segment ${i}` });
  const names = async () => (await app.segments()).map((segment) => segment.name);
  await name(3).fill("limp");
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("x");
  const half = Math.round(first / 2);
  await field(app).fill(String(half));
  await page.keyboard.press("Enter");
  await expectCuts(app, [half, first, second]);
  expect(await names()).toEqual(["limp", "limp", "", "limp"]);
  const { segments } = JSON.parse((await app.saveSegments("Segments")).text);
  expect(segments.map(({ label }: { label: string }) => label)).toEqual([
    "limp",
    "limp",
    "",
    "limp",
  ]);
  await page.keyboard.press("End");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Shift+X");
  await expectCuts(app, [half, first]);
  expect((await names()).slice(0, 2)).toEqual(["limp", "limp"]);
});

test("Escape restores the name as it was, and names nothing", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.segments();
  const name = (i: number) => app.panel.getByRole("textbox", { name: `Name of segment ${i}` });
  await name(1).fill("limp");
  await name(3).focus();
  await page.keyboard.press("Escape");
  await expect(name(3)).not.toBeFocused();
  await name(3).fill("slow limp");
  await page.keyboard.press("Escape");
  await expect(name(3)).toHaveValue("limp");
  await name(1).fill("walk");
  await expect(name(3)).toHaveValue("walk");
  await name(1).fill("");
  await page.keyboard.press("Escape");
  await expect(name(1)).toHaveValue("limp");
  await expect(name(3)).toHaveValue("limp");
});

test("naming by a double click leaves the loop as it was", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const [first = 0] = await cutsOf(app);
  const { x, y } = await pointAtCut(app, first);
  await page.mouse.dblclick(x - 100, y);
  await expect(app.panel.getByRole("textbox", { name: "Name of segment 1" })).toBeFocused();
  await expect(app.timeline.getByRole("button", { name: /^Loop/ })).toHaveText("Loop clip");
});
