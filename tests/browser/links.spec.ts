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

for (const [address, message] of [
  ["javascript:alert(document.domain)", "starts with “javascript:”"],
  ["java%09script:alert(1)", "starts with “javascript:”"],
  ["data:text/plain,HIERARCHY", "starts with “data:”"],
  ["blob:https://example.org/walk", "starts with “blob:”"],
  ["file:///etc/passwd", "starts with “file:”"],
  ["about:blank", "starts with “about:”"],
  ["ftp://example.org/walk.bvh", "starts with “ftp:”"],
  ["https://", "is not valid"],
  ["https:", "is not valid"],
  ["http://[::1/walk.bvh", "is not valid"],
  ["https://name:secret@example.org/walk.bvh", "user name or a password"],
  ["", "contains no address"],
] as const) {
  test(`explains why a link cannot be opened: ${address || "empty"}`, async ({ app, page }) => {
    await page.goto(`${app.site.home}#url=${address}`);
    await expect(app.alert).toContainText("could not be opened");
    await expect(app.alert).toContainText(message);
    await expect(app.alert).toContainText("#url=https://example.org/walk.bvh");
    await expect(app.alert.getByRole("heading")).toHaveText(
      /^(The link|http\S+|walk\.bvh) could not/,
    );
    await expect(page.getByRole("button", { name: "Open a file" })).toBeVisible();
  });
}
