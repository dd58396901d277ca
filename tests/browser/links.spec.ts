import { expect, test } from "./app";

test("a link to a sample opens it, and another link the next", async ({ app, page }) => {
  await app.sample("skipping");
  await page.goto(`${app.site.home}#sample=ballet`);
  await app.opened("ballet.bvh");
});

test("a link to a sample that there is not says so", async ({ app, page }) => {
  await page.goto(`${app.site.home}#sample=moonwalk`);
  await expect(app.alert).toContainText('There is no sample called "moonwalk"');
  await expect(page.getByRole("button", { name: "Open a file" })).toBeVisible();
});

test("a link to a file opens it, encoded or not", async ({ app, page }) => {
  const url = `${app.site.origin}/clips/bowling.bvh`;
  for (const written of [url, encodeURIComponent(url)]) {
    await page.goto("about:blank");
    await page.goto(`${app.site.home}#url=${written}`);
    await app.opened("bowling.bvh");
    await expect(app.stage.locator("canvas")).toBeVisible();
  }
});

test("a link to a file that there is not gives the server's answer", async ({ app, page }) => {
  app.provokes(/console error: .*404.*nothing\.bvh/);
  await page.goto(`${app.site.home}#url=${app.site.origin}/clips/nothing.bvh`);
  await expect(app.alert).toContainText("nothing.bvh could not be opened");
  await expect(app.alert).toContainText("404");
  await expect(app.alert).toContainText("drop it here instead");
});

test("a link to a server that cannot be reached names the server", async ({ app, page }) => {
  const url = "https://plantigrade.invalid/walk.bvh";
  app.provokes(/(elsewhere|failed request|console error): .*plantigrade\.invalid/);
  await page.goto(`${app.site.home}#url=${url}`);
  await expect(app.alert).toContainText("walk.bvh could not be opened");
  await expect(app.alert).toContainText("plantigrade.invalid");
});
