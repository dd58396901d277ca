import { expect, test } from "./app";
import { good, sample } from "./clips";
import { readLabels } from "./labels";

test("seeks by click and scrubs by drag on the timeline", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const middle = await app.pressRuler(0.5);
  expect(middle).toBeGreaterThan(60);
  expect(middle).toBeLessThan(180);
  const { x, y } = await app.ruler(0.5);
  await page.mouse.move(x, y);
  await page.mouse.down();
  let before = middle;
  for (const position of [0.6, 0.7, 0.8]) {
    await page.mouse.move((await app.ruler(position)).x, y, { steps: 3 });
    const now = await app.frame();
    expect(now).toBeGreaterThan(before);
    before = now;
  }
  await page.mouse.move((await app.ruler(2)).x, y);
  await page.mouse.up();
  expect(await app.frame()).toBe(244);
});

test("drags the playhead by its handle", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.pressRuler(0.4);
  const before = await app.frame();
  await app.playhead.hover();
  await page.mouse.down();
  const { x, y } = await app.ruler(0.7);
  await page.mouse.move(x, y, { steps: 4 });
  await page.mouse.up();
  expect(await app.frame()).toBeGreaterThan(before + 30);
});

test("places the playhead at the start, also after a clip without motion", async ({ app }) => {
  const file = sample("bowling");
  await app.openFile(file);
  const start = await app.playhead.boundingBox();
  await app.drop(good("no-motion"));
  await app.waitForClip("no-motion.bvh");
  await app.drop(file);
  await app.waitForClip(file.name);
  await expect.poll(() => app.playhead.boundingBox()).toEqual(start);
});

test("zooms at the pointer by wheel and resets by 0", async ({ app, page }) => {
  await app.openSample("foot-drag-walk");
  const [left, middle, right] = [
    await app.pressRuler(0.3),
    await app.pressRuler(0.5),
    await app.pressRuler(0.7),
  ];
  const { x, y } = await app.ruler(0.5);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -600);
  await expect.poll(() => app.pressRuler(0.3)).toBeGreaterThan(left + 40);
  expect(Math.abs((await app.pressRuler(0.5)) - middle)).toBeLessThanOrEqual(2);
  expect(await app.pressRuler(0.7)).toBeLessThan(right - 40);
  await page.keyboard.press("0");
  expect(await app.pressRuler(0.3)).toBe(left);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -600);
  await app.timeline.getByRole("button", { name: "Fit" }).click();
  expect(await app.pressRuler(0.7)).toBe(right);
});

test("steps through plant edges by Shift and arrow keys", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const { left, right } = readLabels(await app.save("Labels"));
  const spans = [...(left.contact ?? []), ...(right.contact ?? [])];
  const edges = new Set(spans.flatMap(({ start, end }) => [start, end - 1]));
  const ahead = [...edges]
    .sort((a, b) => a - b)
    .filter((edge) => edge > 0)
    .slice(0, 4);
  expect(ahead).toHaveLength(4);
  for (const edge of ahead) {
    await page.keyboard.press("Shift+ArrowRight");
    expect(await app.frame()).toBe(edge);
  }
  const panel = app.panel.getByRole("button", { pressed: true });
  await app.tab("Labels");
  await expect(panel).toHaveCount(0);
  // A selection moves to the plant of the edge.
  await page.keyboard.press("e");
  for (const edge of ahead.reverse().slice(1)) {
    await page.keyboard.press("Shift+ArrowLeft");
    expect(await app.frame()).toBe(edge);
    await expect(panel).toHaveCount(1);
    const fields = app.panel.getByRole("spinbutton");
    const values = await fields.evaluateAll((inputs) =>
      inputs.map((input) => Number((input as HTMLInputElement).value)),
    );
    expect(values).toContain(edge);
  }
});

test("does not move the foot status when its text changes", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const left = app.view.getByText(/^Left in (contact|the air)/);
  const box = await left.boundingBox();
  for (let i = 0; i < 6; i++) {
    await page.keyboard.press("Shift+ArrowRight");
    expect(await left.boundingBox()).toEqual(box);
  }
});

test("goes to the start of a listed plant", async ({ app }) => {
  await app.openSample("limp-to-run");
  const { left, right, rate } = readLabels(await app.save("Labels"));
  const starts = [...(left.contact ?? []), ...(right.contact ?? [])].map(({ start }) => start);
  const plant = app.panel.getByRole("listitem").nth(3).getByRole("button");
  await plant.click();
  const at = await app.frame();
  expect(starts).toContain(at);
  await expect(plant).toContainText((at / rate).toFixed(2));
  await expect(plant).toHaveAttribute("aria-current", "true");
});
