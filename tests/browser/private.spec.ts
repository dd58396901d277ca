import { expect, test } from "./app";
import { sample } from "./clips";
import { readTable } from "./labels";

// The site's own files are kept for later as a part of loading it.
test.use({ serviceWorkers: "allow" });

test("nothing leaves the computer: a loaded page opens, labels and saves without a request", async ({
  app,
  page,
  context,
}) => {
  await app.empty();
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForLoadState("networkidle");
  const asked: string[] = [];
  context.on("request", (request) => asked.push(request.url()));
  await context.setOffline(true);
  await app.drop(sample("one-leg-hop"));
  await app.opened("one-leg-hop.bvh");
  await page.getByRole("slider", { name: "Sensitivity r" }).fill("1");
  expect(readTable(await app.save("Frames")).rows).toHaveLength(336);
  expect(asked.filter((url) => !url.startsWith("blob:"))).toEqual([]);
});
