import { expect, test } from "./app";
import { readLabels } from "./labels";

test("another rate changes the duration", async ({ app, page }) => {
  await app.sample("bowling");
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

test("another up axis is taken up and given back", async ({ app, page }) => {
  await app.sample("foot-drag-walk");
  await app.tab("Clip");
  await expect(app.fact("Up axis")).toHaveText("Z");
  const up = page.getByRole("combobox", { name: "Up axis" });
  await up.selectOption({ label: "Y" });
  await expect(app.fact("Up axis")).toHaveText("Y");
  await expect(app.head).toContainText("Y up");
  await up.selectOption({ label: "Detected" });
  await expect(app.fact("Up axis")).toHaveText("Z");
});

test("another joint can be named as a foot's toe", async ({ app, page }) => {
  await app.sample("bowling");
  const found = readLabels(await app.save("Labels")).joints;
  await app.tab("Clip");
  const toe = page.getByRole("combobox", { name: "Left toe" });
  await toe.selectOption({ label: found.left.heel });
  await expect
    .poll(async () => readLabels(await app.save("Labels")).joints.left.toe)
    .toBe(found.left.heel);
  await app.tab("Clip");
  await toe.selectOption({ label: "Detected" });
  await expect.poll(async () => readLabels(await app.save("Labels")).joints).toEqual(found);
});

test("corrections end with the clip they were made for", async ({ app, page }) => {
  await app.sample("bowling");
  await app.tab("Clip");
  const rate = page.getByRole("spinbutton", { name: "Rate" });
  await rate.fill("60");
  await rate.press("Enter");
  await expect(app.fact("Duration")).toHaveText("5.27 s");
  await page.evaluate(() => {
    location.hash = "#sample=ballet";
  });
  await app.opened("ballet.bvh");
  await expect(rate).toHaveValue("");
  await expect(app.head).toContainText("24 Hz");
});
