import { expect, test } from "./app";
import { repeated, sample } from "./clips";
import { methodNames } from "./core";
import { readTable } from "./labels";

test("offers the detection methods of the core, which label a clip", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const menu = page.getByRole("combobox", { name: "Method" });
  const expected = methodNames().detect;
  await expect(menu).toHaveValue(expected[0] ?? "");
  const names = await menu
    .locator("option")
    .evaluateAll((all) => all.map((option) => (option as HTMLOptionElement).value));
  expect(names).toEqual(expected);
  expect(new Set(names).size).toBe(names.length);
  const lines = new Set<string>();
  for (const name of names) {
    await menu.selectOption(name);
    await expect(app.timeline.locator(".timeline-message")).toBeHidden();
    lines.add(await page.locator("#method-line").innerText());
    expect((await app.result("Left")).plants, name).toBeGreaterThan(0);
  }
  expect(lines.size).toBe(names.length);
});

test("shows threshold sliders for methods with thresholds", async ({ app, page }) => {
  await app.openSample("drunken-stagger");
  const menu = page.getByRole("combobox", { name: "Method" });
  const slider = (name: string) => page.getByRole("slider", { name, exact: true });
  for (const [method, height, speed] of [
    ["robust", false, false],
    ["height", true, false],
    ["speed", false, true],
    ["dual", true, true],
    ["min-speed", false, true],
  ] as const) {
    await menu.selectOption(method);
    await expect(slider("Height")).toBeVisible({ visible: height });
    await expect(slider("Speed")).toBeVisible({ visible: speed });
    await expect(slider("Sensitivity r")).toBeVisible({ visible: method === "robust" });
  }
  await menu.selectOption("dual");
  await expect.poll(() => app.result("Left")).toMatchObject({ plants: expect.any(Number) });
  const before = (await app.result("Left")).percent;
  await slider("Speed").fill("3");
  await slider("Height").fill("0.3");
  await expect.poll(async () => (await app.result("Left")).percent).toBeGreaterThan(before);
  await app.panel.getByRole("button", { name: "Reset speed" }).click();
  await app.panel.getByRole("button", { name: "Reset height" }).click();
  await expect.poll(async () => (await app.result("Left")).percent).toBe(before);
});

test("cancels a slow detection and restores the previous labels", async ({ app, page }) => {
  await app.openFile(repeated(sample("limp-to-run"), 14));
  const before = await app.result("Left");
  const menu = page.getByRole("combobox", { name: "Method" });
  await menu.selectOption("njw");
  const bar = page.getByRole("progressbar", { name: /^Detecting plants/ });
  await expect(bar).toBeVisible();
  await expect(app.panel.locator(".detect-result")).toHaveCSS("opacity", "0.5");
  await page.getByRole("button", { name: "Cancel" }).click();
  await expect(bar).toBeHidden();
  await expect(menu).toHaveValue("robust");
  expect(await app.result("Left")).toEqual(before);
  // A slow detection is also stopped by the next request.
  await menu.selectOption("njw");
  await expect(bar).toBeVisible();
  // A detection that has run for two seconds is stopped by the next request.
  const since = await page.evaluate(() => performance.now());
  await page.waitForFunction((start) => performance.now() - start > 2000, since);
  await menu.selectOption("paper");
  await expect(bar).toBeHidden();
  await expect(app.head.getByRole("alert")).toBeHidden();
  expect(readTable(await app.save("Every frame")).header).toBe("frame,time,left_toe,right_toe");
});

test("shows a method that labels contact only", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await page.getByRole("combobox", { name: "Method" }).selectOption("min-speed");
  const { header, rows } = readTable(await app.save("Every frame"));
  expect(header).toBe("frame,time,left_contact,right_contact");
  const planted = rows.findIndex((row) => row.left_contact === "1");
  for (let i = 0; i < planted; i++) await page.keyboard.press("ArrowRight");
  await expect(app.view.getByText(/^Left in contact/)).toBeVisible();
  expect(await app.panel.getByRole("listitem").count()).toBeGreaterThan(3);
});

test("lists the confidence of every plant and marks uncertain ones", async ({ app, page }) => {
  await app.openSample("foot-drag-walk");
  await page.getByRole("combobox", { name: "Method" }).selectOption("gmm");
  await app.tab("Labels");
  const plants = app.panel.getByRole("listitem").getByRole("button");
  await expect.poll(() => plants.filter({ hasText: "review" }).count()).toBeGreaterThan(0);
  for (const plant of await plants.all()) {
    const percent = Number((await plant.locator(".confidence").textContent())?.match(/^\d+/)?.[0]);
    await expect(plant).toContainText(percent < 95 ? "review" : "%");
    if (percent >= 95) await expect(plant).not.toContainText("review");
  }
});
