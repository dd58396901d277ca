import { cpSync, readdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { App, expect, test } from "./app";
import { root, sample } from "./clips";
import { serve } from "./serve";

test.use({ serviceWorkers: "allow" });

/** Waits until the site is cached and the service worker controls the page. */
const waitForCache = (page: Page) =>
  page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    const { serviceWorker } = navigator;
    const controlled = new Promise((resolve) =>
      serviceWorker.addEventListener("controllerchange", resolve, { once: true }),
    );
    if (!serviceWorker.controller) await controlled;
  });

test("works offline after the first visit", async ({ page, context }) => {
  const site = await serve();
  const app = new App(page, site);
  // The service worker requests the page before it falls back to the cache.
  app.expectProblem(/ERR_INTERNET_DISCONNECTED|ERR_CONNECTION_REFUSED/);
  await app.openStartPage();
  await waitForCache(page);
  await context.setOffline(true);
  await site.close();
  await page.reload();
  await expect(app.state).toHaveAttribute("data-state", "empty");
  await page.getByRole("button", { name: "Frog jumps", exact: true }).click();
  await app.waitForClip("frog-jumps.bvh");
  await app.drop(sample("bowling"));
  await app.waitForClip("bowling.bvh");
  expect((await app.result("Left")).plants).toBeGreaterThan(2);
  expect((await app.savePage()).name).toBe("bowling.html");
  await app.drop(sample("ballet"), sample("skipping"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  expect(app.unexpectedProblems()).toEqual([]);
});

test("loads a new version without interrupting open pages", async ({ page, context }, info) => {
  const folder = info.outputPath("site");
  cpSync(join(root, "web/dist"), folder, { recursive: true });
  const site = await serve(folder);
  const old = new App(page, site);
  await old.openStartPage();
  await waitForCache(page);
  await old.drop(sample("bowling"));
  await old.waitForClip("bowling.bvh");

  publishNewVersion(folder);
  const next = new App(await context.newPage(), site);
  await next.openStartPage();
  const script = next.page.locator("script[type=module]");
  await expect(script).toHaveAttribute("src", /index-newer\.js$/);
  await expect(old.toast).toContainText("A new version is available");
  await expect(next.toast).toHaveCount(0);

  // The old page can still start workers of its own version.
  await old.drop(sample("ballet"), sample("skipping"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await old.toast.getByRole("button", { name: "Reload" }).click();
  await expect(page.locator("script[type=module]")).toHaveAttribute("src", /index-newer\.js$/);
  expect(old.unexpectedProblems()).toEqual([]);
  expect(next.unexpectedProblems()).toEqual([]);
  await context.close();
  await site.close();
});

/** Replaces a build by one whose files have other names. */
function publishNewVersion(folder: string) {
  const assets = join(folder, "assets");
  for (const [kind, ending] of [
    ["index", "js"],
    ["batch.worker", "js"],
  ] as const) {
    const name = readdirSync(assets).find(
      (file) => file.startsWith(`${kind}-`) && file.endsWith(`.${ending}`),
    );
    if (!name) throw new Error(`The site has no ${kind}.`);
    const newer = `${kind}-newer.${ending}`;
    renameSync(join(assets, name), join(assets, newer));
    const others = readdirSync(assets).filter((file) => file.endsWith(".js"));
    const texts = ["index.html", "sw.js", ...others.map((file) => join("assets", file))];
    for (const path of texts.map((text) => join(folder, text))) {
      writeFileSync(path, readFileSync(path, "utf8").replaceAll(name, newer));
    }
  }
  const sw = join(folder, "sw.js");
  // The name of the script has changed, and with it the page.
  const html = /(url:"index\.html",revision:")[^"]*|(revision:")[^"]*(",url:"index\.html)/;
  const text = readFileSync(sw, "utf8");
  writeFileSync(
    sw,
    text.replace(html, (found) => found.replace(/"[0-9a-f]{32}/, '"newer')),
  );
}

test("provides a valid web app manifest", async ({ page, site }) => {
  await page.goto(site.home);
  const href = await page.locator("link[rel=manifest]").getAttribute("href");
  const address = new URL(href ?? "", site.home);
  const manifest = await (await page.request.get(address.href)).json();
  expect(manifest).toMatchObject({ name: "Plantigrade", start_url: "./", display: "standalone" });
  for (const { src, type } of manifest.icons) {
    const icon = await page.request.get(new URL(src, address).href);
    expect(icon.headers()["content-type"]).toBe(type);
  }
});
