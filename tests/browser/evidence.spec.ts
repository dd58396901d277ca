import type { Locator } from "@playwright/test";
import { type App, expect, test } from "./app";
import { repeated, sample } from "./clips";
import { readLabels } from "./labels";

const plot = (app: App, name: string) => app.panel.getByRole("slider", { name });
const scatter = (app: App) => plot(app, "Height and speed");
const norms = (app: App) => plot(app, "Sorted norms");
const variance = (app: App) => plot(app, "Running variance");

/** Returns an output next to the heading of a plot. */
const output = (app: App, text: RegExp) => app.panel.getByText(text);

async function open(app: App, name = "curved-walk") {
  await app.openSample(name);
  await app.tab("Evidence");
  await expect(norms(app)).toBeVisible();
}

/** Returns a point in a plot from fractions of its size. */
async function pointIn(plot: Locator, x: number, y: number) {
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.boundingBox();
  if (!box) throw new Error("The plot is not in sight.");
  return { x: box.x + x * box.width, y: box.y + y * box.height };
}

/** Returns the frame that is selected in a plot. */
const selectedFrame = async (plot: Locator) => Number(await plot.getAttribute("aria-valuenow"));

test("explains the labels of the frame at the playhead", async ({ app, page }) => {
  await open(app);
  const labels = readLabels(await app.save("Labels"));
  await app.tab("Evidence");
  const step = labels.left.contact?.[0];
  if (!step) throw new Error("The left foot is never planted.");
  const words = (label: string) => app.fact(label);
  await app.pressRuler(0.3);
  await page.keyboard.press("Home");
  await expect(words("Left planted")).toHaveText(/^√degree \d\.\d\d, above 0\.\d\d$/);
  await expect(norms(app)).toHaveAttribute("aria-valuetext", /^Frame 0\. Left planted: √degree/);
  for (let i = 0; i < step.end + 2; i++) await page.keyboard.press("ArrowRight");
  await expect(words("Left in the air")).toHaveText(/below 0\.\d\d/);
  await expect(output(app, /^σ 0\.\d\d\d$/)).toBeVisible();
  await expect(output(app, /^knee \d+ %$/)).toBeVisible();
});

test("previews the frame of a hovered point and seeks by click", async ({ app, page }) => {
  await open(app);
  expect(await app.frame()).toBe(0);
  const line = app.timeline.locator(".pointed-frame");
  await expect(line).toBeHidden();
  const view = await app.stage.screenshot();
  const at = await pointIn(norms(app), 0.9, 0.4);
  await page.mouse.move(at.x, at.y);
  await expect(line).toBeVisible();
  const frame = Number(await line.getAttribute("data-frame"));
  expect(frame).toBeGreaterThan(0);
  await expect(app.view.getByText(`Frame ${frame}`, { exact: true })).toBeVisible();
  await expect(app.panel.getByRole("heading", { name: `Frame ${frame}` })).toBeVisible();
  // A large norm belongs to a moving foot.
  await expect(norms(app)).toHaveAttribute("aria-valuetext", /in the air/);
  await expect.poll(() => app.stage.screenshot()).not.toEqual(view);
  expect(await app.frame()).toBe(0);
  await page.mouse.click(at.x, at.y);
  expect(await app.frame()).toBe(frame);
  await page.mouse.move(10, 400);
  await expect(line).toBeHidden();
  await expect(app.view.getByText(/^Frame \d+$/)).toBeHidden();
});

test("seeks by click on a point of the scatter plot", async ({ app, page }) => {
  await open(app);
  const line = app.timeline.locator(".pointed-frame");
  const at = await pointIn(scatter(app), 0.22, 0.8);
  await page.mouse.move(at.x, at.y);
  await expect(line).toBeVisible();
  await page.mouse.click(at.x, at.y);
  expect(await app.frame()).toBe(Number(await line.getAttribute("data-frame")));
  // Low and slow feet are planted.
  await expect(scatter(app)).toHaveAttribute("aria-valuetext", /planted/);
});

test("marks the hovered frame of the timeline in the plots", async ({ app, page }) => {
  await open(app);
  const before = await scatter(app).screenshot();
  const { x, y } = await app.ruler(0.7);
  await page.mouse.move(x, y + 40);
  await expect.poll(() => selectedFrame(scatter(app))).toBeGreaterThan(100);
  await expect.poll(() => scatter(app).screenshot()).not.toEqual(before);
  // Hovering the timeline does not preview frames in the view.
  await expect(app.view.getByText(/^Frame \d+$/)).toBeHidden();
  await app.tab("Detect");
  await page.mouse.move(x + 20, y + 40);
  // Other tabs have the values under the pointer only.
  await expect(app.timeline.locator(".pointed-frame")).toContainText("confidence");
  await page.mouse.move(x, 5);
  await expect(app.timeline.locator(".pointed-frame")).toBeHidden();
});

test("changes r by dragging its line", async ({ app, page }) => {
  await open(app, "drunken-stagger");
  const sigma = output(app, /^σ 0\.\d\d\d$/);
  const before = await sigma.textContent();
  const labels = readLabels(await app.save("Labels"));
  await app.tab("Evidence");
  const field = await scatter(app).screenshot();
  const dragLine = variance(app).locator(".drag-line");
  await dragLine.scrollIntoViewIfNeeded();
  await expect(dragLine).toHaveText("r 0.001");
  const box = await dragLine.boundingBox();
  if (!box) throw new Error("The line of r is not visible.");
  await page.mouse.move(box.x + 100, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 100, box.y - 30, { steps: 5 });
  await page.mouse.up();
  const slider = page.getByRole("slider", { name: "Sensitivity r" });
  await expect(slider).not.toHaveAttribute("aria-valuetext", "r 0.001");
  const r = Number((await slider.getAttribute("aria-valuetext"))?.slice(2));
  expect(r).toBeGreaterThan(0.002);
  await expect(dragLine).toHaveText(`r ${r}`);
  await expect(sigma).not.toHaveText(before ?? "");
  expect(await app.frame()).toBe(0);
  await expect.poll(() => scatter(app).screenshot()).not.toEqual(field);
  const after = readLabels(await app.save("Labels"));
  expect(after.method.r).toBe(r);
  expect(after.left).not.toEqual(labels.left);
});

test("updates the plots when r or the window changes", async ({ app, page }) => {
  await open(app, "drunken-stagger");
  const sigma = output(app, /^σ 0\.\d\d\d$/);
  const initial = await sigma.textContent();
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("0");
  await expect(variance(app).locator(".drag-line")).toHaveText("r 0.0002");
  await expect(sigma).not.toHaveText(initial ?? "");
  await app.panel.getByRole("button", { name: "Reset sensitivity" }).click();
  await expect(sigma).toHaveText(initial ?? "");
  await page.getByRole("slider", { name: "Window w" }).fill("4");
  await expect(sigma).not.toHaveText(initial ?? "");
});

test("navigates the plots by keyboard", async ({ app, page }) => {
  await open(app);
  await page.getByRole("tab", { name: "Evidence" }).focus();
  const steps = ["panel", "Contact", "Toe", "Heel", "Height and speed"];
  for (const _ of steps) await page.keyboard.press("Tab");
  await expect(scatter(app)).toBeFocused();
  await page.keyboard.press("ArrowRight");
  await expect(scatter(app)).toHaveAttribute("aria-valuenow", "1");
  expect(await app.frame()).toBe(0);
  await page.keyboard.press("End");
  await expect(scatter(app)).toHaveAttribute("aria-valuenow", "244");
  await page.keyboard.press("Escape");
  await expect(scatter(app)).toHaveAttribute("aria-valuenow", "0");
  await page.keyboard.press("Tab");
  await expect(variance(app)).toBeFocused();
  await page.keyboard.press("Tab");
  await expect(norms(app)).toBeFocused();
  await page.keyboard.press("End");
  const last = await selectedFrame(norms(app));
  await expect(app.view.getByText(`Frame ${last}`, { exact: true })).toBeVisible();
  await page.keyboard.press("ArrowLeft");
  expect(await selectedFrame(norms(app))).not.toBe(last);
  const next = await selectedFrame(norms(app));
  await page.keyboard.press("Enter");
  expect(await app.frame()).toBe(next);
  await page.keyboard.press("Tab");
  await expect(page.getByRole("slider", { name: "Sensitivity r" })).toBeFocused();
  await expect(app.view.getByText(/^Frame \d+$/)).toBeHidden();
});

test("shows the evidence of the selected part", async ({ app, page }) => {
  await open(app);
  const initial = await output(app, /^σ/).textContent();
  await app.panel.getByRole("button", { name: "Heel" }).click();
  await expect(output(app, /^σ/)).not.toHaveText(initial ?? "");
  await app.tab("Detect");
  await page.getByRole("combobox", { name: "Method" }).selectOption("paper");
  await app.tab("Evidence");
  await expect(norms(app)).toBeVisible();
  await expect(app.panel.getByRole("button", { name: "Heel" })).toBeHidden();
  await expect(app.fact("Left planted")).toHaveText(/^√degree/);
});

test("shows thresholds, and reports methods without evidence", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const method = page.getByRole("combobox", { name: "Method" });
  await method.selectOption("dual");
  await app.tab("Evidence");
  await expect(app.panel).toContainText("does not use clustering, so it has no σ and no r");
  await expect(app.fact("Left planted")).toHaveText(/cm, below 5\.00;\s*0\.\d\d m\/s, below 0\.50/);
  await expect(norms(app)).toBeHidden();
  const { x, y } = await pointIn(scatter(app), 0.25, 0.8);
  await page.mouse.move(x, y);
  await expect(app.timeline.locator(".pointed-frame")).toBeVisible();
  for (const [name, words] of [
    ["gmm", /not a spectral method/],
    ["njw", /no boundary is drawn/],
    ["sigma", /determines σ in another way/],
  ] as const) {
    await app.tab("Detect");
    await method.selectOption(name);
    await app.tab("Evidence");
    await expect(app.panel).toContainText(words);
  }
});

test("explains an edited label", async ({ app, page }) => {
  await open(app);
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect(app.fact("Left in the air")).toHaveText("edited");
});

test("reports that no frame was clustered", async ({ app }) => {
  const still = sample("curved-walk").buffer.toString("utf8");
  const [head = "", motion = ""] = still.split(/(?=Frame Time:)/);
  const rows = motion.trim().split(/\r?\n/);
  const text = [rows[0], ...rows.slice(1).map(() => rows[9])].join("\n");
  await app.openFile({
    name: "still.bvh",
    mimeType: "text/plain",
    buffer: Buffer.from(`${head}${text}\n`),
  });
  await app.tab("Evidence");
  await expect(app.panel).toContainText("The frames were not clustered");
  await expect(norms(app)).toBeHidden();
});

test("shows the evidence of a long clip", async ({ app, page }) => {
  await app.openFile(repeated(sample("curved-walk"), 40));
  await app.tab("Evidence");
  await expect(norms(app)).toBeVisible();
  const { x, y } = await pointIn(norms(app), 0.7, 0.5);
  await page.mouse.move(x, y);
  await expect(app.timeline.locator(".pointed-frame")).toBeVisible();
});
