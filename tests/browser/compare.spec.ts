import { type App, expect, test } from "./app";
import { clip, file, good, type Payload, sample } from "./clips";

const truth = (name: string) => clip(`samples/${name}.json`);

/** Drops labels beside the clip that is open. */
async function compare(app: App, labels: Payload) {
  await app.drop(labels);
  await expect(app.page.getByRole("tabpanel", { name: "Score" })).toContainText(labels.name);
}

/** A number of the table of agreement, in percent. */
async function agreement(app: App, within: string, column = 0): Promise<number> {
  const row = app.panel.getByRole("row", { name: new RegExp(`^${within} s`) });
  return Number(await row.getByRole("cell").nth(column).innerText());
}

for (const name of ["bowling", "curved-walk", "ballet"]) {
  test(`${name} agrees with its truth, dropped together with it`, async ({ app, page }) => {
    await app.empty();
    await app.drop(truth(name), sample(name));
    await app.opened(`${name}.bvh`);
    await expect(page.getByRole("tabpanel", { name: "Score" })).toContainText(`${name}.json`);
    for (const part of ["Contact", "Toe", "Heel"]) {
      await app.panel.getByRole("button", { name: part, exact: true }).click();
      await expect(app.panel.getByRole("button", { name: part, pressed: true })).toBeVisible();
      expect(await agreement(app, "0.3")).toBeGreaterThanOrEqual(98);
      expect(await agreement(app, "0.0")).toBeLessThanOrEqual(await agreement(app, "0.3"));
    }
  });
}

test("a sample can be compared with its truth, and the comparison removed", async ({
  app,
  page,
}) => {
  await app.sample("foot-drag-walk");
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
  await app.tab("Labels");
  const lanes = await app.tracks.screenshot();
  await app.panel.getByRole("button", { name: "Compare with ground truth" }).click();
  await expect(page.getByRole("tabpanel", { name: "Score" })).toContainText("foot-drag-walk truth");
  expect(await app.tracks.screenshot()).not.toEqual(lanes);
  await app.panel.getByRole("button", { name: "Remove" }).click();
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
  await expect.poll(() => app.tracks.screenshot()).toEqual(lanes);
});

test("N and the list go from difference to difference", async ({ app, page }) => {
  await app.sample("bowling");
  await compare(app, truth("bowling"));
  await app.tab("Detect");
  // Thresholds leave something to disagree about.
  await page.getByRole("combobox", { name: "Method" }).selectOption("speed");
  await app.tab("Score");
  // Rows out of sight do not exist.
  await app.panel.evaluate((panel) => panel.scrollTo(0, panel.scrollHeight));
  const items = app.panel.getByRole("listitem").getByRole("button");
  await expect.poll(() => items.count()).toBeGreaterThan(2);
  const seconds = (await items.allInnerTexts()).map((text) => Number(/\d+\.\d\d/.exec(text)?.[0]));
  const starts = [...new Set(seconds.map((at) => Math.round(at * 30)))].filter((at) => at > 0);
  for (const start of starts.slice(0, 3)) {
    await page.keyboard.press("n");
    expect(await app.frame()).toBe(start);
  }
  await page.keyboard.press("Shift+N");
  expect(await app.frame()).toBe(starts.slice(0, 3).at(-2));
  await items.first().click();
  expect(await app.frame()).toBe(Math.round((seconds[0] ?? 0) * 30));
  await expect(items.first()).toHaveAttribute("aria-current", "true");
  await page.keyboard.press("?");
  await expect(app.dialog).toContainText("Next difference");
});

test("the score follows the method and its settings", async ({ app, page }) => {
  await app.sample("limp-to-run");
  await compare(app, truth("limp-to-run"));
  const robust = await agreement(app, "0.0");
  await app.tab("Detect");
  await page.getByRole("combobox", { name: "Method" }).selectOption("min-speed");
  await app.tab("Score");
  await expect.poll(() => agreement(app, "0.0")).not.toBe(robust);
  await expect(app.panel.getByRole("button", { name: "Toe", exact: true })).toBeHidden();
});

for (const [button, ending] of [
  ["Labels", "JSON"],
  ["Frames", "CSV"],
] as const) {
  test(`labels saved as ${ending} agree with themselves`, async ({ app }) => {
    await app.sample("frog-jumps");
    const saved = await app.save(button);
    await app.drop(file(saved.name, saved.text));
    await app.tab("Score");
    await expect(app.panel).toContainText(saved.name);
    for (const column of [0, 1, 2, 3]) expect(await agreement(app, "0.0", column)).toBe(100);
    await expect(app.panel.getByRole("listitem")).toHaveCount(0);
  });
}

test("a truth file may leave frames open", async ({ app }) => {
  await app.with(good("plain"));
  const [left, right] = [Array(12).fill(1), Array(12).fill(-1)];
  await app.drop(file("mine.json", JSON.stringify({ fps: 30, left, right })));
  await app.tab("Score");
  await expect(app.panel).toContainText("mine.json");
  await expect(app.alert).toBeHidden();
});

test("labels of another clip are refused in words", async ({ app, page }) => {
  await app.sample("bowling");
  await app.drop(truth("ballet"));
  await expect(app.alert.getByRole("heading")).toHaveText("ballet.json could not be opened");
  await expect(app.alert).toContainText("298");
  await expect(app.alert).toContainText("316");
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
});

test("what is no labels is refused in words", async ({ app }) => {
  await app.sample("bowling");
  await app.drop(file("shopping.csv", "milk,bread\n1,2\n"));
  await expect(app.alert.getByRole("heading")).toHaveText("shopping.csv could not be opened");
  await expect(app.alert).toContainText("bowling.bvh is still open");
});

test("labels without a clip ask for one", async ({ app }) => {
  await app.empty();
  await app.drop(truth("ballet"));
  await expect(app.alert).toContainText("Open the clip first, or drop both together");
});

test("the comparison ends with the clip", async ({ app, page }) => {
  await app.sample("bowling");
  await compare(app, truth("bowling"));
  await app.drop(good("plain"));
  await app.opened("plain.bvh");
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
});
