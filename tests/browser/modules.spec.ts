/** The two wasm modules: what waits for which. */

import type { Page } from "@playwright/test";
import { type App, expect, test } from "./app";
import { sample } from "./clips";

const address = /plantigrade_second-[^/]*\.wasm$/;
const firstAddress = /plantigrade_bg-[^/]*\.wasm$/;

/** Delays a module until the returned function is called. */
async function holdModule(page: Page, address: RegExp): Promise<() => void> {
  let release = () => {};
  const released = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(address, async (route) => {
    await released;
    await route.continue();
  });
  return release;
}

const isLabelled = (app: App) =>
  expect(app.timeline.getByRole("table", { name: /plants/ }).first()).toBeAttached();

test("a link loads the first module before the 3D view, and no picture of the start page", async ({
  app,
  page,
}) => {
  const release = await holdModule(page, firstAddress);
  const requested: string[] = [];
  page.on("request", (request) => requested.push(new URL(request.url()).pathname));
  const others = () => requested.filter((path) => /stage-.*\.js$|\.webp$/.test(path));
  await page.goto(`${app.site.home}#sample=curved-walk`);
  // The clip and the font are requested at the same time as three.js would be.
  await expect.poll(() => requested.filter((path) => /\.(bvh|woff2)$/.test(path)).length).toBe(2);
  expect(others()).toEqual([]);
  release();
  await expect(app.stage.locator("canvas")).toBeVisible();
  expect(others()).toEqual([expect.stringMatching(/stage-.*\.js$/)]);
});

test("states that the 3D view is loading, or that it cannot be loaded", async ({ app, page }) => {
  const stageAddress = /stage-[^/]*\.js$/;
  const loading = page.getByText("Loading the 3D view");
  const release = await holdModule(page, stageAddress);
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await isLabelled(app);
  await expect(loading).toBeVisible();
  release();
  await expect(app.stage.locator("canvas")).toBeVisible();
  await expect(loading).toBeHidden();

  await page.unroute(stageAddress);
  await page.route(stageAddress, (route) => route.abort());
  app.expectProblem(/stage-|Failed to load resource/);
  await page.goto("about:blank");
  await page.goto(`${app.site.home}#sample=ballet`);
  await isLabelled(app);
  await expect(page.getByText("3D view unavailable: it could not be loaded")).toBeVisible();
});

test("shows the first labels while the second module loads", async ({ app, page }) => {
  const release = await holdModule(page, address);
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await isLabelled(app);
  expect((await app.result("Left")).plants).toBe(3);
  await app.tab("Segment");
  await expect(page.getByText("Segmenting")).toBeVisible();
  release();
  expect((await app.segments()).length).toBeGreaterThan(0);
  await app.waitForClip("curved-walk.bvh");
});

test("detects by another method after the second module has loaded", async ({ app, page }) => {
  const release = await holdModule(page, address);
  await page.goto(`${app.site.home}#sample=curved-walk&method=paper`);
  await page.waitForRequest(address);
  release();
  await app.waitForClip("curved-walk.bvh");
  expect((await app.result("Left")).plants).toBeGreaterThan(0);
});

test("reports a failed download, and tries again", async ({ app, page }) => {
  app.expectProblem(/plantigrade_second|Failed to load resource/);
  await page.route(address, (route) => route.abort());
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await isLabelled(app);
  await app.tab("Segment");
  await expect(app.panel).toContainText("part of the program could not be loaded");
  await app.tab("Evidence");
  await expect(app.alert).toContainText("Check the connection to the network");
  await page.unroute(address);
  await app.alert.getByRole("button", { name: "Try again" }).click();
  await expect(app.panel.getByRole("slider").first()).toBeVisible();
  await app.tab("Segment");
  await app.panel.getByRole("button", { name: "Try again" }).click();
  expect((await app.segments()).length).toBeGreaterThan(0);
});

test("processes a batch after the second module has loaded", async ({ app, page }) => {
  const release = await holdModule(page, address);
  await app.openStartPage();
  await app.drop(sample("ballet"), sample("skipping"));
  await page.waitForRequest(address).catch(() => {});
  release();
  await expect(page.getByText(/^All processed/)).toBeVisible();
});
