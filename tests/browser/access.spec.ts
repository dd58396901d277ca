import AxeBuilder from "@axe-core/playwright";
import { type App, expect, test } from "./app";
import { bad, clip, file, good } from "./clips";

/** Every state of the page, and how to get there. */
const states: Record<string, (app: App) => Promise<void>> = {
  "the empty page": (app) => app.empty(),
  "the Detect tab": (app) => app.sample("bowling"),
  "the Why tab": async (app) => {
    await app.sample("bowling");
    await app.tab("Evidence");
    await app.page.getByRole("slider", { name: "Sorted norms" }).press("ArrowRight");
    await expect(app.view.getByText(/^Frame \d+$/)).toBeVisible();
  },
  "the Why tab of a threshold": async (app) => {
    await app.sample("bowling");
    await app.page.getByRole("combobox", { name: "Method" }).selectOption("dual");
    await app.tab("Evidence");
    await expect(app.panel).toContainText("thresholds");
  },
  "the Segment tab": async (app) => {
    await app.sample("limp-to-run");
    await app.tab("Segment");
    await app.drop(file("mine.csv", "start_frame,end_frame,label\n0,300,walk\n300,744,run\n"));
    await expect(app.panel).toContainText("mine.csv");
    await app.page.getByRole("combobox", { name: "Method" }).selectOption("lsd");
    await app.panel.getByRole("button", { name: /^Loop segment 1/ }).click();
    await app.panel.getByRole("button", { name: "Save", exact: true }).click();
  },
  "the Labels tab": async (app) => {
    await app.sample("bowling");
    await app.tab("Labels");
  },
  "the Score tab": async (app) => {
    await app.sample("bowling");
    await app.drop(clip("samples/bowling.json"));
    await app.tab("Score");
  },
  "the Clip tab": async (app) => {
    await app.sample("bowling");
    await app.tab("Clip");
  },
  "the list of keys": async (app) => {
    await app.sample("bowling");
    await app.page.keyboard.press("?");
    await expect(app.dialog).toBeVisible();
  },
  "the ways to share a sample": async (app) => {
    await app.sample("bowling");
    await app.share();
  },
  "the ways to share a file": async (app) => {
    await app.with(good("plain"));
    await app.share();
  },
  "a remark on a link": async (app) => {
    await app.page.goto(`${app.site.home}#sample=bowling&method=magic`);
    await app.opened("bowling.bvh");
    await expect(app.remark).toContainText("magic");
  },
  "the list of notices": async (app) => {
    await app.with(good("breaks-off"));
    await app.head.getByRole("button", { name: /notice/ }).click();
    await expect(app.dialog).toBeVisible();
  },
  "a file refused": async (app) => {
    await app.with(good("plain"));
    await app.drop(bad("not-a-number"));
    await expect(app.alert).toBeVisible();
  },
  "a table of many clips": async (app) => {
    await app.empty();
    await app.drop(bad("ragged-row"), good("no-motion"), good("plain"));
    await expect(app.page.getByText(/^All processed/)).toBeVisible();
  },
  "a plant being edited": async (app) => {
    await app.sample("curved-walk");
    await app.tab("Labels");
    await app.page.keyboard.press("e");
    await app.page.keyboard.press("k");
  },
  "a skeleton without motion": (app) => app.with(good("no-motion")),
};

for (const colorScheme of ["dark", "light"] as const) {
  for (const [name, reach] of Object.entries(states)) {
    test(`${name} is accessible in the ${colorScheme}`, async ({ app, page }) => {
      await page.emulateMedia({ colorScheme });
      await reach(app);
      const { violations } = await new AxeBuilder({ page }).analyze();
      const found = violations.flatMap(({ id, nodes }) =>
        nodes.map(({ target, failureSummary }) => `${id}: ${target.join(" ")} ${failureSummary}`),
      );
      expect(found).toEqual([]);
    });
  }
}
