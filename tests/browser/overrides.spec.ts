import { expect, test } from "./app";
import { readLabels } from "./labels";

test("overrides the frame rate", async ({ app, page }) => {
  await app.openSample("bowling");
  await app.tab("Clip");
  await expect(app.fact("Duration")).toHaveText("10.5 s");
  const rate = page.getByRole("spinbutton", { name: "Rate" });
  await rate.fill("60");
  await rate.press("Enter");
  await expect(app.fact("Duration")).toHaveText("5.27 s");
  await expect(app.head).toContainText("60 Hz");
  expect(readLabels(await app.save("Labels")).rate).toBeCloseTo(60, 6);
  await app.tab("Clip");
  await rate.fill("");
  await rate.press("Enter");
  await expect(app.fact("Duration")).toHaveText("10.5 s");
});

test("overrides the up axis and restores the detected one", async ({ app, page }) => {
  await app.openSample("foot-drag-walk");
  await app.tab("Clip");
  await expect(app.fact("Up axis")).toHaveText("Z");
  const up = page.getByRole("combobox", { name: "Up axis" });
  await up.selectOption({ label: "Y" });
  await expect(app.fact("Up axis")).toHaveText("Y");
  await expect(app.head).toContainText("Y up");
  await up.selectOption({ label: "Detected" });
  await expect(app.fact("Up axis")).toHaveText("Z");
});

test("overrides a foot joint and restores the detected one", async ({ app, page }) => {
  await app.openSample("bowling");
  const found = readLabels(await app.save("Labels")).joints;
  await app.tab("Clip");
  const toe = page.getByRole("combobox", { name: "Left toe", exact: true });
  await toe.selectOption({ label: found.left.heel });
  await expect
    .poll(async () => readLabels(await app.save("Labels")).joints.left.toe)
    .toBe(found.left.heel);
  await app.tab("Clip");
  await toe.selectOption({ label: "Detected" });
  await expect.poll(async () => readLabels(await app.save("Labels")).joints).toEqual(found);
});

test("resets overrides when another clip is opened", async ({ app, page }) => {
  await app.openSample("bowling");
  await app.tab("Clip");
  const rate = page.getByRole("spinbutton", { name: "Rate" });
  await rate.fill("60");
  await rate.press("Enter");
  await expect(app.fact("Duration")).toHaveText("5.27 s");
  await page.evaluate(() => {
    location.hash = "#sample=ballet";
  });
  await app.waitForClip("ballet.bvh");
  await expect(rate).toHaveValue("");
  await expect(app.head).toContainText("24 Hz");
});

test("explains the joint of a role and marks it in the view", async ({ app, page }) => {
  await app.openSample("bowling");
  await app.tab("Clip");
  const ankle = page.getByRole("combobox", { name: "Left ankle" });
  await expect(ankle).toHaveAccessibleDescription(/9\d % by name, connected bones, the other side/);
  const view = page.getByRole("img", { name: /Skeleton of/ });
  const unmarked = await view.screenshot();
  await ankle.focus();
  await expect.poll(async () => unmarked.equals(await view.screenshot())).toBe(false);
  await ankle.blur();
  await page.mouse.move(5, 5);
  await expect.poll(async () => unmarked.equals(await view.screenshot())).toBe(true);
  await ankle.selectOption({ index: 4 });
  await expect(ankle).toHaveAccessibleDescription(/100 % by your choice/);
});

test("overrides the unit", async ({ app, page }) => {
  await app.openSample("bowling");
  await app.tab("Clip");
  const unit = page.getByRole("spinbutton", { name: "Metres per unit" });
  await unit.fill("0.02");
  await unit.press("Enter");
  await expect(app.fact("Unit")).toHaveText("0.02 m");
});
