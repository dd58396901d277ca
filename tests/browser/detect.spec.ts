import { type App, expect, test } from "./app";
import { readLabels, readTable } from "./labels";

const both = async (app: App) => [await app.result("Left"), await app.result("Right")];

test("the sensitivity changes the result, and the labels follow", async ({ app, page }) => {
  await app.sample("drunken-stagger");
  const r = page.getByRole("slider", { name: "Sensitivity r" });
  const before = await both(app);
  const labels = readLabels(await app.save("Labels"));
  await app.tab("Detect");
  await r.focus();
  await page.keyboard.press("End");
  await expect(r).toHaveAttribute("aria-valuetext", "r 0.0044");
  await expect.poll(() => both(app)).not.toEqual(before);
  const generous = readLabels(await app.save("Labels"));
  expect(generous.method.r).toBe(0.0044);
  expect(generous.left).not.toEqual(labels.left);
  await app.tab("Detect");
  await app.panel.getByRole("button", { name: "Reset sensitivity" }).click();
  await expect.poll(() => both(app)).toEqual(before);
});

test("a greater sensitivity plants the feet longer", async ({ app, page }) => {
  await app.sample("drunken-stagger");
  const planted = async () => (await both(app)).reduce((sum, { share }) => sum + share, 0);
  const usual = await planted();
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("0");
  await expect.poll(planted).toBeLessThan(usual);
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("1");
  await expect.poll(planted).toBeGreaterThan(usual);
});

test("the window changes, is said in words and goes with the labels", async ({ app, page }) => {
  await app.sample("drunken-stagger");
  const w = page.getByRole("slider", { name: "Window w" });
  for (const [value, words] of [
    ["4", "± 4 frames"],
    ["0", "1 frame"],
  ] as const) {
    await w.fill(value);
    await expect(app.panel.getByText(words, { exact: true })).toBeVisible();
    await expect
      .poll(async () => readLabels(await app.save("Labels")).method.w)
      .toBe(Number(value));
    await app.tab("Detect");
  }
});

test("the paper's method labels toes only, and says so", async ({ app, page }) => {
  await app.sample("limp-to-run");
  const contact = await both(app);
  const lanes = await app.tracks.screenshot();
  await page.getByRole("combobox", { name: "Method" }).selectOption("paper");
  await expect(app.panel.locator("#method-line")).toContainText(/toes/i);
  await expect.poll(() => both(app)).not.toEqual(contact);
  expect(await app.tracks.screenshot()).not.toEqual(lanes);
  const { head, rows } = readTable(await app.save("Frames"));
  expect(head).toBe("frame,time,left_toe,right_toe");
  expect(rows).toHaveLength(744);
  const labels = readLabels(await app.save("Labels"));
  expect(labels.method.name).toBe("paper");
  expect(labels.left.contact).toBeUndefined();
  expect(labels.left.toe?.length).toBeGreaterThan(0);
});
