/** Pictures of every clip for a person to look at; what the page says in them is checked. */

import { join } from "node:path";
import { type App, expect, test } from "./app";
import { recorded, root, samples } from "./clips";
import { readTable, type Table } from "./labels";

/** Places on the timeline, from its left edge to its right one. */
const moments = [0.35, 0.6, 0.85];
const devices = {
  desktop: { width: 1440, height: 900 },
  phone: { width: 390, height: 844 },
} as const;

for (const [i, { name, title }] of samples.entries()) {
  test(`${title} looks as its labels say`, async ({ app }) => {
    await app.sample(name);
    await takePictures(app, name, i);
  });
}

const recordings = [
  "cmu/86_01",
  "cmu/131_03",
  "dialects/bandai_dataset-1_run_tired_001",
  "dialects/rokoko_jesse_dance",
  "dialects/pybvh_example_zup",
  "dialects/freebvh_mixamo",
];

for (const [i, path] of recordings.entries()) {
  test(`the recording ${path} looks as its labels say`, async ({ app, page }) => {
    const file = recorded(`${path}.bvh`);
    test.skip(!file, "No recorded motion here: PLANTIGRADE_CORPUS can name its folder.");
    if (!file) return;
    await app.empty();
    await page.locator("input[type=file]").setInputFiles(file);
    const name = path.replace(/^.*\//, "");
    await app.opened(`${name}.bvh`);
    await takePictures(app, name, i);
  });
}

/** Desktop and phone, one of them light and the other dark, turn about. */
async function takePictures(app: App, name: string, turn: number) {
  const { page } = app;
  const table = readTable(await app.save("Every frame"));
  await app.tab("Detect");
  for (const [j, [device, viewport]] of Object.entries(devices).entries()) {
    await page.setViewportSize(viewport);
    await page.emulateMedia({ colorScheme: (turn + j) % 2 ? "light" : "dark" });
    // A tab that was chosen is a raised panel on a phone.
    const lower = page.getByRole("button", { name: "Lower the panel" });
    if (await lower.isVisible()) await lower.click();
    await page.keyboard.press("Home");
    let before = 0;
    for (const [k, moment] of moments.entries()) {
      const now = await app.pressRuler(moment);
      expect(now).toBeGreaterThan(before);
      before = now;
      await expectPills(app, table);
      // The camera comes to rest.
      await page.waitForTimeout(250);
      await page.screenshot({
        path: join(root, `test-results/looks/${name}-${device}-${k + 1}.png`),
      });
    }
  }
}

/** Words over the picture agree with the row of the frame in the table that the app saves. */
async function expectPills(app: App, { rows }: Table) {
  const row = rows[await app.frame()];
  for (const [side, name] of [
    ["left", "Left"],
    ["right", "Right"],
  ] as const) {
    const words = row?.[`${side}_contact`] === "1" ? "planted" : "in the air";
    await expect(app.view.getByText(new RegExp(`^${name} (planted|in the air)`))).toContainText(
      words,
    );
  }
}
