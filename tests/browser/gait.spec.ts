/** Gait measures in the Clip tab. */

import AxeBuilder from "@axe-core/playwright";
import { type App, expect, test } from "./app";
import { viewports } from "./viewports";

const row = (app: App, name: RegExp) =>
  app.panel.getByRole("table", { name: "Gait" }).getByRole("row", { name });

/** Returns the mean of the left and the right side in a row of the table. */
async function means(app: App, name: RegExp): Promise<number[]> {
  const cells = await row(app, name).getByRole("cell").allInnerTexts();
  return cells.map((text) => Number.parseFloat(text.replace("−", "-")));
}

const steps = (app: App) =>
  app.panel.getByRole("listitem").filter({ has: app.page.getByText(", foot strike") });

test("measures percentages, times and lengths of a walk with their deviations", async ({ app }) => {
  await app.openSample("curved-walk");
  await app.tab("Clip");
  await expect(row(app, /^Step length/)).toHaveText(/6\d.*(6\d|7\d)/);
  await expect(row(app, /^Step width/)).toHaveText(/1\d.*1\d/);
  const [stance = 0, swing = 0] = [await means(app, /^Stance %/), await means(app, /^Swing %/)].map(
    ([left = 0]) => left,
  );
  expect(stance).toBeGreaterThan(55);
  expect(stance + swing).toBeCloseTo(100, 0);
  const cadence = Number.parseFloat(await app.fact("Cadence").innerText());
  expect(Math.abs(cadence - 112)).toBeLessThan(4);
  await expect(app.fact("Double support")).toContainText("% of a stride");
  await expect(app.fact("Surface")).toHaveText("overground");
  await expect(app.fact("Strides left out")).toHaveText(/\d cut off/);
});

test("measures asymmetry of a limp and flight of a run", async ({ app }) => {
  await app.openSample("limp-to-run");
  await app.tab("Clip");
  await expect(row(app, /^Stance time/)).toHaveText(/± 0\.\d\d.*± 0\.\d\d/);
  await expect(app.fact("Symmetry index, stance")).toHaveText(/^right \+\d+ %$/);
  await expect(app.fact("Flight")).toContainText("% of a stride");
});

test("measures each action separately", async ({ app }) => {
  await app.openSample("limp-to-run");
  await app.tab("Clip");
  const choice = app.panel.getByRole("combobox", { name: "Action whose gait is measured" });
  await expect(choice.getByRole("option")).toHaveText([/^Whole clip$/, /^A, frames/, /^B, frames/]);
  await expect(app.fact("Cadence")).toHaveText("130 steps/min");
  await choice.selectOption({ index: 1 });
  // The limp is slower than the mean, and the run is faster.
  await expect(app.fact("Cadence")).toHaveText(/^10\d steps\/min$/);
  await expect(app.fact("Flight")).toBeHidden();
  await choice.selectOption({ index: 2 });
  await expect(app.fact("Cadence")).toHaveText(/^16\d steps\/min$/);
  const saved = await app.saveGait("Steps");
  expect(saved.text.split("\n", 1)[0]).toMatch(/^action,foot,strike_frame/);
  await choice.selectOption("");
  await expect(app.fact("Cadence")).toHaveText("130 steps/min");
});

test("lists steps, and a row moves the playhead", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.tab("Clip");
  const saved = await app.saveGait("Steps");
  expect(saved.name).toBe("limp-to-run.steps.csv");
  const [header = "", ...lines] = saved.text.trim().split("\n");
  const column = (line: string, name: string) => line.split(",")[header.split(",").indexOf(name)];
  expect(lines.length).toBeGreaterThan(60);
  await expect(app.panel.getByRole("heading", { name: `Steps ${lines.length}` })).toBeVisible();
  const [first = "", second = ""] = lines;
  await steps(app).nth(1).getByRole("button").click();
  await expect(app.playhead).toHaveAttribute("aria-valuenow", column(second, "strike_frame") ?? "");
  await expect(steps(app).nth(1).getByRole("button")).toHaveAttribute("aria-current", "true");
  // By keyboard, too.
  await steps(app).first().getByRole("button").focus();
  await page.keyboard.press("Enter");
  await expect(app.playhead).toHaveAttribute("aria-valuenow", column(first, "strike_frame") ?? "");
  await expect(steps(app).first()).toContainText(Number(column(first, "strike_s")).toFixed(2));
});

test("shows joint angles and the position of the playhead in the gait cycle", async ({ app }) => {
  await app.openSample("limp-to-run");
  await app.tab("Clip");
  for (const name of ["Hip flexion", "Knee flexion", "Ankle dorsiflexion"]) {
    const plot = app.panel.getByRole("img", { name: new RegExp(`^${name} over the gait cycle`) });
    await expect(plot).toHaveAccessibleName(/left −?\d+° to \d+°, right −?\d+° to \d+°$/);
    await expect(plot.locator("canvas")).toBeVisible();
  }
  const position = app.panel.locator(".cycle-position");
  await expect(position).toHaveText(/L –\s*R –/);
  await steps(app).nth(4).getByRole("button").click();
  // The foot that strikes is at the beginning of its cycle, the other one about the middle.
  await expect(position).toHaveText(/L \d %\s*R [3-7]\d %/);
  const saved = await app.saveGait("Joint angles");
  expect(saved.text.split("\n")).toHaveLength(103);
});

test("opens a printable report that compares the actions", async ({ app, page }) => {
  await page.addInitScript(() => {
    window.print = () => document.documentElement.setAttribute("data-printed", "");
  });
  await page.context().addInitScript(() => {
    window.print = () => document.documentElement.setAttribute("data-printed", "");
  });
  await app.openSample("limp-to-run");
  await app.tab("Clip");
  const opened = page.waitForEvent("popup");
  await app.panel.getByRole("button", { name: "Report", exact: true }).click();
  const report = await opened;
  const problems: string[] = [];
  report.on("console", (message) => problems.push(message.text()));
  await expect(report.getByRole("heading", { name: "limp-to-run.bvh" })).toBeVisible();
  await expect(report.getByRole("columnheader", { name: "Action A" })).toBeVisible();
  await expect(report.getByRole("columnheader", { name: "Action B" })).toBeVisible();
  await expect(report.getByText("not clinical angles")).toBeVisible();
  await expect(report.getByRole("img", { name: /^Knee flexion/ })).toHaveCount(2);
  // The style is allowed by the policy of the app.
  await expect(report.locator("html")).toHaveCSS("background-color", "rgb(230, 233, 237)");
  await expect(report.locator("html")).toHaveAttribute("data-printed", "");
  expect((await new AxeBuilder({ page: report }).analyze()).violations).toEqual([]);
  const pdf = await report.pdf();
  const pages = pdf.toString("latin1").match(/\/Type \/Page\b/g) ?? [];
  expect(pages).toHaveLength(2);
  expect(problems).toEqual([]);
  await report.close();
});

test("updates gait measures after edits and shows none for jumps", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.tab("Clip");
  const stance = row(app, /^Stance time/);
  const before = await stance.innerText();
  // The first complete plant of the right foot.
  for (let i = 0; i < 90; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("e");
  for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("o");
  await expect(stance).not.toHaveText(before);
  await app.openSample("frog-jumps");
  await app.tab("Clip");
  await expect(app.panel.getByRole("heading", { name: "Foot joints" })).toBeVisible();
  await expect(app.panel.getByRole("heading", { name: "Gait" })).toBeHidden();
});

for (const scheme of ["dark", "light"] as const) {
  test.describe(`on a phone, ${scheme}`, () => {
    test.use({ viewport: viewports.phone, colorScheme: scheme });

    test("is complete and accessible", async ({ app, page }) => {
      await app.openSample("limp-to-run");
      await app.tab("Clip");
      await expect(row(app, /^Step width/)).toBeVisible();
      await steps(app).first().getByRole("button").scrollIntoViewIfNeeded();
      await steps(app).first().getByRole("button").click();
      await expect(app.playhead).not.toHaveAttribute("aria-valuenow", "0");
      const overflow = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      expect(overflow).toBe(0);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    });
  });
}
