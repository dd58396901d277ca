import { expect, test } from "./app";
import { samples } from "./clips";

test("has thirteen samples", () => {
  expect(samples).toHaveLength(13);
});

for (const { name, title } of samples) {
  test(`opens the sample ${title} from the gallery and labels both feet`, async ({ app, page }) => {
    await app.openStartPage();
    await page.getByRole("button", { name: title, exact: true }).click();
    await app.waitForClip(`${name}.bvh`);
    await expect(page).toHaveURL(`${app.site.home}#sample=${name}`);
    for (const foot of ["Left", "Right"] as const) {
      const { percent, plants } = await app.result(foot);
      expect(percent).toBeGreaterThanOrEqual(5);
      expect(percent).toBeLessThanOrEqual(100);
      expect(plants).toBeGreaterThanOrEqual(1);
    }
  });
}
