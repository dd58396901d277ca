import { expect, test } from "./app";
import { samples } from "./clips";

test("there are thirteen samples", () => {
  expect(samples).toHaveLength(13);
});

for (const { name, title } of samples) {
  test(`the sample ${title} opens from the gallery and has both feet planted`, async ({
    app,
    page,
  }) => {
    await app.empty();
    await page.getByRole("button", { name: title, exact: true }).click();
    await app.opened(`${name}.bvh`);
    await expect(page).toHaveURL(`${app.site.home}#sample=${name}`);
    for (const foot of ["Left", "Right"] as const) {
      const { share, plants } = await app.result(foot);
      expect(share).toBeGreaterThanOrEqual(5);
      expect(share).toBeLessThanOrEqual(100);
      expect(plants).toBeGreaterThanOrEqual(1);
    }
  });
}
