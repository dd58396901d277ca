import { expect, test } from "./app";
import { sample } from "./clips";
import { readTable } from "./labels";

// Loading includes caching the files of the site.
test.use({ serviceWorkers: "allow" });

test("opens, labels and saves without network requests", async ({ app, page, context }) => {
  await app.openStartPage();
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForLoadState("networkidle");
  const requested: string[] = [];
  context.on("request", (request) => requested.push(request.url()));
  await context.setOffline(true);
  await app.drop(sample("one-leg-hop"));
  await app.waitForClip("one-leg-hop.bvh");
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("1");
  expect(readTable(await app.save("Every frame")).rows).toHaveLength(336);
  expect(requested.filter((url) => !url.startsWith("blob:"))).toEqual([]);
});
