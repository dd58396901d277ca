/** Opening a clip while the app is still busy with another one. */

import type { Page } from "@playwright/test";
import { type App, expect, test } from "./app";
import { bad, type Payload, repeated, sample } from "./clips";

/** A clip that takes longer to read than the others of these tests, and minutes to segment by MVU. */
const large = { ...repeated(sample("limp-to-run"), 20), name: "large.bvh" };
/** A clip that takes so long to read that another file can be dropped meanwhile. */
const huge = { ...repeated(sample("limp-to-run"), 150), name: "huge.bvh" };
const small = sample("one-leg-hop");

/** Number of plants of both feet. */
const plants = async (app: App) => [
  (await app.result("Left")).plants,
  (await app.result("Right")).plants,
];

const method = (app: App) => app.panel.getByRole("combobox", { name: "Method" });

/** Starts a segmentation during which the worker of the open clip does nothing else. */
async function occupyWorker(app: App) {
  await app.tab("Segment");
  await method(app).selectOption("mvu");
  await expect(app.page.getByRole("button", { name: "Cancel" })).toBeVisible();
  await method(app).blur();
}

/** Drops a file, and another one while the first one is read. */
async function dropWhileReading(app: App, first: Payload, second: Payload) {
  const transfers = [await app.transfer(first), await app.transfer(second)] as const;
  await app.page.evaluate(async ([first, second]) => {
    const drop = (dataTransfer: DataTransfer) =>
      dispatchEvent(new DragEvent("drop", { dataTransfer }));
    const progress = () => document.querySelector<HTMLProgressElement>(".progress progress");
    drop(first);
    while (!progress()?.value) await new Promise((resolve) => setTimeout(resolve, 0));
    drop(second);
  }, transfers);
}

test("a clip that is opened during an edit of another one has its own labels and edits", async ({
  app,
  page,
}) => {
  await app.openFile(small);
  const expected = await plants(app);
  await app.openFile(large);
  await occupyWorker(app);
  // Both wait for the segmentation.
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await app.tab("Labels");
  await app.panel.getByRole("button", { name: "Save", exact: true }).click();
  const saved = page.waitForEvent("download");
  await app.panel.getByRole("button", { name: /^Labels/ }).click();
  await app.drop(small);
  expect((await saved).suggestedFilename()).toBe("large.plants.json");
  await expect(page).toHaveTitle(/one-leg-hop/);
  await expect.poll(() => plants(app)).toEqual(expected);
  await app.waitForClip(small.name);
  const { frames, source } = JSON.parse((await app.save("Labels")).text);
  expect(frames).toBe((await app.lastFrame()) + 1);
  expect(source.name).toBe(small.name);
  // Each clip has its own record.
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect.poll(async () => (await plants(app))[0]).toBe((expected[0] ?? 0) - 1);
  const records = await page.evaluate(() =>
    Object.entries(localStorage)
      .filter(([key]) => key.startsWith("plantigrade:clip:"))
      .map(([, text]) => JSON.parse(text)),
  );
  expect(records.map(({ name, edits }) => `${name} ${edits.length}`).sort()).toEqual([
    `${large.name} 1`,
    `${small.name} 1`,
  ]);
});

/** Numbers of edits in the records of clips, by their names. */
const recordedEdits = (page: Page) =>
  page.evaluate(() =>
    Object.fromEntries(
      Object.entries(localStorage)
        .filter(([key]) => key.startsWith("plantigrade:clip:"))
        .map(([, text]) => JSON.parse(text))
        .map(({ name, edits }) => [name, edits.length]),
    ),
  );

/** Moves the end of the first plant twelve times without waiting. Returns the number of edits that this is. */
async function editQuickly(app: App): Promise<number> {
  const { page } = app;
  await page.keyboard.press("e");
  await page.keyboard.press("w");
  const ofOne = () => recordedEdits(page).then((records) => records[large.name]);
  await expect.poll(ofOne).toBeGreaterThan(0);
  const count = await ofOne();
  await page.evaluate(() => {
    for (let i = 0; i < 11; i++)
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "w", bubbles: true }));
  });
  return 12 * count;
}

test("edits that are not applied yet are stored when another clip is opened", async ({
  app,
  page,
}) => {
  await app.openFile(large);
  const count = await editQuickly(app);
  await app.drop(small);
  await app.waitForClip(small.name);
  expect((await recordedEdits(page))[large.name]).toBe(count);
});

test("edits that are not applied yet are stored when the start page is shown", async ({
  app,
  page,
}) => {
  await app.openFile(large);
  const count = await editQuickly(app);
  await app.head.getByRole("button", { name: "Plantigrade" }).click();
  await expect(page).toHaveTitle("Plantigrade");
  expect((await recordedEdits(page))[large.name]).toBe(count);
});

test("a clip stays open if a file is dropped that cannot be read while another one is read", async ({
  app,
}) => {
  await app.openFile(small);
  const expected = await plants(app);
  await dropWhileReading(app, huge, bad("not-a-number"));
  await expect(app.alert).toContainText(`${small.name} is still open`);
  await app.tab("Detect");
  await method(app).selectOption("speed");
  await method(app).selectOption("robust");
  await expect.poll(() => plants(app)).toEqual(expected);
  const { frames } = JSON.parse((await app.save("Labels")).text);
  expect(frames).toBe((await app.lastFrame()) + 1);
});

for (const viewport of [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
]) {
  test(`an error does not cover the progress of an opening, ${viewport.width} pixels wide`, async ({
    app,
    page,
  }) => {
    await page.setViewportSize(viewport);
    await app.openFile(small);
    await dropWhileReading(app, huge, {
      name: "broken.zip",
      mimeType: "application/zip",
      buffer: Buffer.from("PK\u0003\u0004"),
    });
    const bounds = await page.waitForFunction(() => {
      const cards = [".error-card", ".progress"].map((name) => document.querySelector(name));
      return (
        cards.every((card) => card) && cards.map((card) => card?.getBoundingClientRect().toJSON())
      );
    });
    const [error, progress] = (await bounds.jsonValue()) as DOMRect[];
    expect(progress?.top).toBeGreaterThan(error?.bottom ?? Number.POSITIVE_INFINITY);
    expect(progress?.bottom).toBeLessThan(viewport.height);
    await expect(app.alert).not.toContainText("still open");
  });
}
