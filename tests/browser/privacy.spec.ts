import type { Request } from "@playwright/test";
import { expect, test } from "./app";
import { sample } from "./clips";
import { readTable } from "./labels";

// Loading includes caching the files of the site.
test.use({ serviceWorkers: "allow" });

test("opens, labels and saves without network requests", async ({ app, page, context }) => {
  await app.openStartPage();
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForLoadState("networkidle");
  const requests: Request[] = [];
  context.on("request", (request) => requests.push(request));
  await context.setOffline(true);
  await app.drop(sample("one-leg-hop"));
  await app.waitForClip("one-leg-hop.bvh");
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("1");
  expect(readTable(await app.save("Every frame")).rows).toHaveLength(336);
  // Parts of the program that are loaded when they are needed come from the cache.
  const uncached = [];
  for (const request of requests.filter((request) => !request.url().startsWith("blob:"))) {
    if (!(await request.response())?.fromServiceWorker()) uncached.push(request.url());
  }
  expect(uncached).toEqual([]);
});
