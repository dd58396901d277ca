import { type App, expect, test } from "./app";
import { readLabels, readTable } from "./labels";

const both = async (app: App) => [await app.result("Left"), await app.result("Right")];

test("updates result and labels when the sensitivity changes", async ({ app, page }) => {
  await app.openSample("drunken-stagger");
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

test("a higher sensitivity increases the planted fraction", async ({ app, page }) => {
  await app.openSample("drunken-stagger");
  const planted = async () => (await both(app)).reduce((sum, { percent }) => sum + percent, 0);
  const initial = await planted();
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("0");
  await expect.poll(planted).toBeLessThan(initial);
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("1");
  await expect.poll(planted).toBeGreaterThan(initial);
});

test("shows the window length and saves it with the labels", async ({ app, page }) => {
  await app.openSample("drunken-stagger");
  const w = page.getByRole("slider", { name: "Window w" });
  for (const [value, text] of [
    ["4", "± 4 frames"],
    ["0", "1 frame"],
  ] as const) {
    await w.fill(value);
    await expect(app.panel.getByText(text, { exact: true })).toBeVisible();
    await expect
      .poll(async () => readLabels(await app.save("Labels")).method.w)
      .toBe(Number(value));
    await app.tab("Detect");
  }
});

test("the paper method labels toes only", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const contact = await both(app);
  const tracks = await app.tracks.screenshot();
  await page.getByRole("combobox", { name: "Method" }).selectOption("paper");
  await expect(app.panel.locator("#method-line")).toContainText(/toes/i);
  await expect.poll(() => both(app)).not.toEqual(contact);
  expect(await app.tracks.screenshot()).not.toEqual(tracks);
  const { header, rows } = readTable(await app.save("Every frame"));
  expect(header).toBe("frame,time,left_toe,right_toe");
  expect(rows).toHaveLength(744);
  const labels = readLabels(await app.save("Labels"));
  expect(labels.method.name).toBe("paper");
  expect(labels.left.contact).toBeUndefined();
  expect(labels.left.toe?.length).toBeGreaterThan(0);
});
