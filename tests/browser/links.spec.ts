import { expect, test } from "./app";

test("opens the sample of a link and of a later one", async ({ app, page }) => {
  await app.openSample("skipping");
  await page.goto(`${app.site.home}#sample=ballet`);
  await app.waitForClip("ballet.bvh");
});

test("reports a link to an unknown sample", async ({ app, page }) => {
  await page.goto(`${app.site.home}#sample=moonwalk`);
  await expect(app.alert).toContainText('There is no sample called "moonwalk"');
  await expect(page.getByRole("button", { name: "Open a file" })).toBeVisible();
});

test("opens the file of a link, encoded or not", async ({ app, page }) => {
  const url = `${app.site.origin}/clips/bowling.bvh`;
  for (const written of [url, encodeURIComponent(url)]) {
    await page.goto("about:blank");
    await page.goto(`${app.site.home}#url=${written}`);
    await app.waitForClip("bowling.bvh");
    await expect(app.stage.locator("canvas")).toBeVisible();
  }
});

test("reports the status of a link to a missing file", async ({ app, page }) => {
  app.expectProblem(/console error: .*404.*nothing\.bvh/);
  await page.goto(`${app.site.home}#url=${app.site.origin}/clips/nothing.bvh`);
  await expect(app.alert).toContainText("nothing.bvh could not be opened");
  await expect(app.alert).toContainText("404");
  await expect(app.alert).toContainText("drop it here instead");
});

test("reports the host of a link that cannot be reached", async ({ app, page }) => {
  const url = "https://plantigrade.invalid/walk.bvh";
  app.expectProblem(/(elsewhere|failed request|console error): .*plantigrade\.invalid/);
  await page.goto(`${app.site.home}#url=${url}`);
  await expect(app.alert).toContainText("walk.bvh could not be opened");
  await expect(app.alert).toContainText("plantigrade.invalid");
});
