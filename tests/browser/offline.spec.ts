import { cpSync, readdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { App, expect, test } from "./app";
import { root, sample } from "./clips";
import { serve } from "./serve";

test.use({ serviceWorkers: "allow" });

/** Waits until the site is kept, and the page is served from what is kept. */
const kept = (page: Page) =>
  page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    const { serviceWorker } = navigator;
    const controlled = new Promise((resolve) =>
      serviceWorker.addEventListener("controllerchange", resolve, { once: true }),
    );
    if (!serviceWorker.controller) await controlled;
  });

test("after one visit the app opens, labels and shares without a network", async ({
  page,
  context,
}) => {
  const site = await serve();
  const app = new App(page, site);
  // The newest page is asked for before the one that is kept is taken.
  app.provokes(/ERR_INTERNET_DISCONNECTED|ERR_CONNECTION_REFUSED/);
  await app.empty();
  await kept(page);
  await context.setOffline(true);
  await site.close();
  await page.reload();
  await expect(app.state).toHaveAttribute("data-state", "empty");
  await page.getByRole("button", { name: "Frog jumps", exact: true }).click();
  await app.opened("frog-jumps.bvh");
  await app.drop(sample("bowling"));
  await app.opened("bowling.bvh");
  expect((await app.result("Left")).plants).toBeGreaterThan(2);
  expect((await app.sharePage()).name).toBe("bowling.html");
  await app.drop(sample("ballet"), sample("skipping"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  expect(app.complaints()).toEqual([]);
});

test("a new version comes with the next load, and what is open goes on", async ({
  page,
  context,
}, info) => {
  const folder = info.outputPath("site");
  cpSync(join(root, "web/dist"), folder, { recursive: true });
  const site = await serve(folder);
  const old = new App(page, site);
  await old.empty();
  await kept(page);
  await old.drop(sample("bowling"));
  await old.opened("bowling.bvh");

  publishAnother(folder);
  const next = new App(await context.newPage(), site);
  await next.empty();
  const script = next.page.locator("script[type=module]");
  await expect(script).toHaveAttribute("src", /index-newer\.js$/);
  await expect(old.remark).toContainText("A new version is available");
  await expect(next.remark).toHaveCount(0);

  // Workers that the old page has not started yet are still to be had.
  await old.drop(sample("ballet"), sample("skipping"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await old.remark.getByRole("button", { name: "Reload" }).click();
  await expect(page.locator("script[type=module]")).toHaveAttribute("src", /index-newer\.js$/);
  expect(old.complaints()).toEqual([]);
  expect(next.complaints()).toEqual([]);
  await context.close();
  await site.close();
});

/** Puts a build in place of another: its files have other names, and those before are gone. */
function publishAnother(folder: string) {
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
  // The page has changed with its script's name.
  const html = /(url:"index\.html",revision:")[^"]*|(revision:")[^"]*(",url:"index\.html)/;
  const text = readFileSync(sw, "utf8");
  writeFileSync(
    sw,
    text.replace(html, (found) => found.replace(/"[0-9a-f]{32}/, '"newer')),
  );
}

test("the app can be installed", async ({ page, site }) => {
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
