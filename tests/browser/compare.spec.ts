import { type App, expect, test } from "./app";
import { clip, file, good, type Payload, sample, twoPeople } from "./clips";

const truth = (name: string) => clip(`samples/${name}.json`);

/** Compares the open clip with labels. */
async function compare(app: App, labels: Payload) {
  await app.drop(labels);
  await expect(app.page.getByRole("tabpanel", { name: "Score" })).toContainText(labels.name);
}

/** Returns a cell of the agreement table, in percent. */
async function agreement(app: App, within: string, column = 0): Promise<number> {
  const row = app.panel.getByRole("row", { name: new RegExp(`^${within} s`) });
  return Number(await row.getByRole("cell").nth(column).innerText());
}

for (const name of ["bowling", "curved-walk", "ballet"]) {
  test(`${name} agrees with ground truth that is dropped with it`, async ({ app, page }) => {
    await app.openStartPage();
    await app.drop(truth(name), sample(name));
    await app.waitForClip(`${name}.bvh`);
    await expect(page.getByRole("tabpanel", { name: "Score" })).toContainText(`${name}.json`);
    for (const part of ["Contact", "Toe", "Heel"]) {
      await app.panel.getByRole("button", { name: part, exact: true }).click();
      await expect(app.panel.getByRole("button", { name: part, pressed: true })).toBeVisible();
      expect(await agreement(app, "0.3")).toBeGreaterThanOrEqual(98);
      expect(await agreement(app, "0.0")).toBeLessThanOrEqual(await agreement(app, "0.3"));
    }
  });
}

test("compares a sample with ground truth and removes the comparison", async ({ app, page }) => {
  await app.openSample("foot-drag-walk");
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
  await app.tab("Labels");
  const tracks = await app.tracks.screenshot();
  await app.panel.getByRole("button", { name: "Compare with reference" }).click();
  await expect(page.getByRole("tabpanel", { name: "Score" })).toContainText("foot-drag-walk truth");
  expect(await app.tracks.screenshot()).not.toEqual(tracks);
  await app.panel.getByRole("button", { name: "Remove" }).click();
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
  await expect.poll(() => app.tracks.screenshot()).toEqual(tracks);
});

test("goes to differences by key and from the list", async ({ app, page }) => {
  await app.openSample("bowling");
  await compare(app, truth("bowling"));
  await app.tab("Detect");
  // The threshold method differs from the ground truth.
  await page.getByRole("combobox", { name: "Method" }).selectOption("speed");
  await app.tab("Score");
  // The list renders visible rows only.
  await app.panel.evaluate((panel) => panel.scrollTo(0, panel.scrollHeight));
  const items = app.panel.getByRole("listitem").getByRole("button");
  await expect.poll(() => items.count()).toBeGreaterThan(2);
  const seconds = (await items.allInnerTexts()).map((text) => Number(/\d+\.\d\d/.exec(text)?.[0]));
  const starts = [...new Set(seconds.map((at) => Math.round(at * 30)))].filter((at) => at > 0);
  for (const start of starts.slice(0, 3)) {
    await page.keyboard.press("d");
    expect(await app.frame()).toBe(start);
  }
  await page.keyboard.press("Shift+D");
  expect(await app.frame()).toBe(starts.slice(0, 3).at(-2));
  await items.first().click();
  expect(await app.frame()).toBe(Math.round((seconds[0] ?? 0) * 30));
  await expect(items.first()).toHaveAttribute("aria-current", "true");
  await page.keyboard.press("?");
  await expect(app.dialog).toContainText("Next difference");
});

test("playback does not scroll the accuracies away", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await compare(app, truth("limp-to-run"));
  const table = app.panel.getByRole("table", { name: /^Accuracy/ });
  await expect(table).toBeInViewport({ ratio: 1 });
  await page.keyboard.press("End");
  for (let i = 0; i < 3; i++) await page.keyboard.press("j");
  await expect.poll(() => app.frame()).toBeLessThan(600);
  await expect(table).toBeInViewport({ ratio: 1 });
  await page.keyboard.press("k");
});

test("shows the curves next to reference labels, or reports that they do not fit", async ({
  app,
  page,
}) => {
  await app.openSample("limp-to-run");
  const tracks = app.timeline.getByRole("button", { name: /^Tracks/ });
  const notice = app.timeline.getByText(/^There is no space/);
  await compare(app, truth("limp-to-run"));
  await expect(tracks).toHaveText("Tracks");
  await page.setViewportSize({ width: 1440, height: 640 });
  await expect(tracks).toContainText("not shown");
  await tracks.click();
  await expect(notice).toContainText(/ cut score and speed\./);
  await app.timeline.getByRole("checkbox", { name: "Heel and toe" }).uncheck();
  await app.timeline.getByRole("checkbox", { name: "Height and speed" }).uncheck();
  await expect(notice).toBeHidden();
  await expect(tracks).toHaveText("Tracks");
});

test("updates the score when the method changes", async ({ app, page }) => {
  await app.openSample("limp-to-run");
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
  ["Every frame", "CSV"],
] as const) {
  test(`labels saved as ${ending} agree with the detection`, async ({ app }) => {
    await app.openSample("frog-jumps");
    const saved = await app.save(button);
    await app.drop(file(saved.name, saved.text));
    await app.tab("Score");
    await expect(app.panel).toContainText(saved.name);
    for (const column of [0, 1, 2, 3]) expect(await agreement(app, "0.0", column)).toBe(100);
    await expect(app.panel.getByRole("listitem")).toHaveCount(0);
  });
}

test("labels of one of two people agree when they are read back from any format", async ({
  app,
}) => {
  await app.openFile(twoPeople(sample("frog-jumps")));
  for (const button of ["Labels", "Every frame", "Every plant", "Arrays"] as const) {
    const { name, bytes } = await app.save(button);
    await app.drop({ ...file(name, ""), buffer: Buffer.from(bytes) });
    await app.tab("Score");
    await expect(app.panel).toContainText(name);
    for (const column of [0, 1, 2, 3]) expect(await agreement(app, "0.0", column)).toBe(100);
    await app.panel.getByRole("button", { name: "Remove", exact: true }).click();
  }
  await expect(app.alert).toBeHidden();
});

test("accepts a reference with unknown frames", async ({ app }) => {
  await app.openFile(good("plain"));
  const [left, right] = [Array(12).fill(1), Array(12).fill(-1)];
  await app.drop(file("partial.json", JSON.stringify({ fps: 30, left, right })));
  await app.tab("Score");
  await expect(app.panel).toContainText("partial.json");
  await expect(app.alert).toBeHidden();
});

test("rejects labels of another clip", async ({ app, page }) => {
  await app.openSample("bowling");
  await app.drop(truth("ballet"));
  await expect(app.alert.getByRole("heading")).toHaveText("ballet.json could not be opened");
  await expect(app.alert).toContainText("298");
  await expect(app.alert).toContainText("316");
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
});

test("rejects a file without labels", async ({ app }) => {
  await app.openSample("bowling");
  await app.drop(file("shopping.csv", "milk,bread\n1,2\n"));
  await expect(app.alert.getByRole("heading")).toHaveText("shopping.csv could not be opened");
  await expect(app.alert).toContainText("bowling.bvh is still open");
});

test("rejects labels if no clip is open", async ({ app }) => {
  await app.openStartPage();
  await app.drop(truth("ballet"));
  await expect(app.alert).toContainText("Open the clip first, or drop both together");
});

test("removes the comparison when another clip is opened", async ({ app, page }) => {
  await app.openSample("bowling");
  await compare(app, truth("bowling"));
  await app.drop(good("plain"));
  await app.waitForClip("plain.bvh");
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
});
