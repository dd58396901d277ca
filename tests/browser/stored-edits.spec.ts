/** Edits survive reloads, other tabs, full storage, and records of other versions or damaged ones. */

import { App, expect, test } from "./app";
import { sample } from "./clips";
import { type Labels, readLabels } from "./labels";
import { keyOf, storeRecord } from "./stored-records";

const key = keyOf(sample("curved-walk"));

const contact = async (app: App, side: "left" | "right" = "left") => {
  const labels: Labels = readLabels(await app.save("Labels"));
  return labels[side].contact?.map(({ start, end }) => [start, end] as const) ?? [];
};
const plantCount = async (app: App) =>
  (await contact(app, "left")).length + (await contact(app, "right")).length;

/** Selects a plant in the list of the Labels tab. */
async function selectPlant(app: App, number: number) {
  await app.tab("Labels");
  await app.panel.getByRole("button", { name: new RegExp(`^${number} ?(Left|Right)`) }).click();
}

async function deletePlant(app: App, number: number) {
  await selectPlant(app, number);
  await app.panel.getByRole("button", { name: "Delete", exact: true }).click();
}

/** Opens the same site in another tab. */
async function otherTab(app: App): Promise<App> {
  const other = new App(await app.page.context().newPage(), app.site);
  await other.openSample("curved-walk");
  return other;
}

/** Opens the clip after its record was stored. */
async function openWithRecord(app: App, text: string) {
  await app.page.goto(app.site.home);
  await storeRecord(app, sample("curved-walk"), text);
  await app.openSample("curved-walk");
}

const storedTexts = (app: App) => app.page.evaluate(() => Object.values({ ...localStorage }));

const edit = { side: "left", part: "contact", start: 0, end: 60, planted: false };
const record = { version: 1, name: "curved-walk.bvh", edits: [edit], names: [] };

/** Withholds storage events from the page, and lets it read what the storage contained before. */
async function isolateStorage(app: App) {
  await app.page.addInitScript(() => {
    const state = { isIsolated: false };
    Object.assign(globalThis, { storageState: state });
    addEventListener("storage", (event) => {
      if (state.isIsolated) event.stopImmediatePropagation();
    });
  });
}

const setIsolated = (app: App, isIsolated: boolean) =>
  app.page.evaluate((value) => {
    (globalThis as unknown as { storageState: { isIsolated: boolean } }).storageState.isIsolated =
      value;
  }, isIsolated);

test("shows edits of another tab and adds to them", async ({ app, page }) => {
  await app.openSample("curved-walk");
  expect(await plantCount(app)).toBe(5);
  const other = await otherTab(app);
  await deletePlant(app, 1);
  await expect(other.timeline).toContainText("Edits were changed in another tab");
  await expect.poll(() => plantCount(other)).toBe(4);
  await deletePlant(other, 4);
  await expect.poll(() => plantCount(app)).toBe(3);
  // Undo reverts the edit of its own tab.
  await app.page.bringToFront();
  await page.keyboard.press("Control+z");
  await expect.poll(() => plantCount(app)).toBe(4);
  await expect.poll(() => plantCount(other)).toBe(4);
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(() => plantCount(app)).toBe(4);
  await expect(app.timeline.getByText(/another tab/)).toBeHidden();
  expect(other.unexpectedProblems()).toEqual([]);
});

test("merges edits of a tab that has not noticed those of another one", async ({ app, page }) => {
  await isolateStorage(app);
  await app.openSample("curved-walk");
  const other = await otherTab(app);
  await setIsolated(app, true);
  await deletePlant(other, 1);
  await deletePlant(app, 5);
  await expect.poll(() => plantCount(app)).toBe(3);
  await expect.poll(() => plantCount(other)).toBe(3);
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(() => plantCount(app)).toBe(3);
});

test("merges edits that were stored over those of another tab", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await deletePlant(app, 1);
  const before = await page.evaluate((key) => localStorage.getItem(key), key);
  await deletePlant(app, 1);
  expect(await plantCount(app)).toBe(3);
  // What a tab writes that still has a cached copy of the storage.
  const other = await app.page.context().newPage();
  await other.goto(app.site.home);
  await other.evaluate(
    ([key, text]) => {
      const record = JSON.parse(text);
      record.ancestors = [record.revision];
      record.revision = "other";
      record.edits.push({ side: "right", part: "contact", start: 0, end: 245, planted: false });
      localStorage.setItem(key, JSON.stringify(record));
    },
    [key, before ?? ""] as const,
  );
  await expect.poll(async () => (await contact(app, "right")).length).toBe(0);
  const left = (await contact(app, "left")).length;
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(async () => (await contact(app, "right")).length).toBe(0);
  expect((await contact(app, "left")).length).toBe(left);
});

test("lets the user choose where both tabs have edited the same plant", async ({ app, page }) => {
  await isolateStorage(app);
  await app.openSample("curved-walk");
  const [first] = await contact(app);
  const [start = 0, end = 0] = first ?? [];
  const other = await otherTab(app);
  await setIsolated(app, true);
  const setEnd = async (tab: App, frame: number) => {
    const [plant] = await contact(tab);
    expect(plant).toEqual([start, end]);
    await tab.panel
      .getByRole("button", { name: /^\d+ ?Left/ })
      .first()
      .click();
    const field = tab.panel.getByRole("spinbutton", { name: "Last frame" });
    await field.fill(String(frame - 1));
    await field.press("Tab");
  };
  await setEnd(other, end - 5);
  await setEnd(app, end - 9);
  await expect(app.timeline).toContainText("Edits conflict with those of another tab");
  await expect(app.panel).toContainText("where they differ, those of this tab take precedence");
  expect((await contact(app))[0]).toEqual([start, end - 9]);
  await setIsolated(app, false);
  await app.panel.getByRole("button", { name: "Use those of the other tab" }).click();
  await expect.poll(async () => (await contact(app))[0]).toEqual([start, end - 5]);
  await expect.poll(async () => (await contact(other))[0]).toEqual([start, end - 5]);
  await app.page.bringToFront();
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await contact(app))[0]).toEqual([start, end - 9]);
});

test("reads records of the first version", async ({ app, page }) => {
  await openWithRecord(app, JSON.stringify(record));
  await expect.poll(async () => (await contact(app))[0]?.[0]).toBeGreaterThanOrEqual(60);
  await deletePlant(app, 4);
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(() => plantCount(app)).toBe(3);
  await expect(app.timeline.getByText("Stored edits cannot be read")).toBeHidden();
});

test("sets records of newer versions aside when the clip is edited", async ({ app, page }) => {
  const text = JSON.stringify({ version: 99, name: "curved-walk.bvh", layers: [1, 2, 3] });
  await openWithRecord(app, text);
  await expect(app.timeline).toContainText("Stored edits cannot be read");
  expect(await page.evaluate((key) => localStorage.getItem(key), key)).toBe(text);
  await app.timeline.getByRole("button", { name: "Details" }).click();
  await expect(app.panel).toContainText("from a newer version of the app");
  await deletePlant(app, 1);
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(() => plantCount(app)).toBe(4);
  expect(await storedTexts(app)).toContain(text);
  await expect(app.panel).toContainText("from a newer version of the app");
  const saved = await app.download(() =>
    app.panel.getByRole("button", { name: "Download them" }).click(),
  );
  expect(saved.text).toBe(text);
  await app.panel.getByRole("button", { name: "Delete them" }).click();
  await expect(app.timeline.getByText("Stored edits cannot be read")).toBeHidden();
  expect(await storedTexts(app)).not.toContain(text);
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(() => plantCount(app)).toBe(4);
});

const withEdit = (change: object) => JSON.stringify({ ...record, edits: [{ ...edit, ...change }] });

const malformed: Record<string, string> = {
  "text that is not JSON": "{edits",
  "an empty text": "",
  null: "null",
  "a number": "7",
  "a list": "[]",
  "an object without fields": "{}",
  "no version": JSON.stringify({ ...record, version: undefined }),
  "a version that is a text": JSON.stringify({ ...record, version: "1" }),
  "version 2 without a revision": JSON.stringify({ ...record, version: 2 }),
  "no edits": JSON.stringify({ ...record, edits: undefined }),
  "edits that are an object": JSON.stringify({ ...record, edits: {} }),
  "an edit that is null": JSON.stringify({ ...record, edits: [null] }),
  "an unknown side": withEdit({ side: "middle" }),
  "an unknown part": withEdit({ part: "knee" }),
  "a negative frame": withEdit({ start: -1 }),
  "a fractional frame": withEdit({ end: 10.5 }),
  "a frame that is a text": withEdit({ end: "60" }),
  "an end before the start": withEdit({ start: 60, end: 10 }),
  "an enormous frame": withEdit({ end: 1e300 }),
  "planted that is not a boolean": withEdit({ planted: "yes" }),
  "names that are texts": JSON.stringify({ ...record, names: ["walk"] }),
  "no names": JSON.stringify({ ...record, names: undefined }),
};

for (const [kind, text] of Object.entries(malformed)) {
  test(`sets a malformed record aside: ${kind}`, async ({ app, page }) => {
    await openWithRecord(app, text);
    await expect(app.timeline).toContainText("Stored edits cannot be read");
    expect(await plantCount(app)).toBe(5);
    await deletePlant(app, 1);
    await expect(app.panel).toContainText("damaged and cannot be read");
    await expect(app.alert).toBeHidden();
    await page.reload();
    await app.waitForClip("curved-walk.bvh");
    await expect.poll(() => plantCount(app)).toBe(4);
    expect(await storedTexts(app)).toContain(text);
  });
}

for (const [reason, error, message] of [
  ["full", "QuotaExceededError", "The storage of this browser is full"],
  ["denied", "SecurityError", "This browser does not store data for this page"],
] as const) {
  test(`has edits until the page is closed if storage is ${reason}`, async ({ app, page }) => {
    await page.addInitScript((name) => {
      const refuse = () => {
        throw new DOMException("refused", name);
      };
      Storage.prototype.setItem = refuse;
      if (name === "SecurityError") Storage.prototype.getItem = refuse;
    }, error);
    await app.openSample("curved-walk");
    await deletePlant(app, 1);
    await expect(app.timeline).toContainText("Edits are not stored");
    await expect(app.panel).toContainText(message);
    await page.goto(`${app.site.home}#sample=bowling`);
    await app.waitForClip("bowling.bvh");
    await expect(app.timeline.getByText("Edits are not stored")).toBeHidden();
    await page.goto(`${app.site.home}#sample=curved-walk`);
    await app.waitForClip("curved-walk.bvh");
    await expect.poll(() => plantCount(app)).toBe(4);
    await expect(app.timeline).toContainText("Edits are not stored");
    // The browser asks before the page is closed.
    const asked = page.waitForEvent("dialog");
    const closed = page.close({ runBeforeUnload: true });
    const dialog = await asked;
    expect(dialog.type()).toBe("beforeunload");
    await dialog.dismiss();
    await closed;
  });
}

test("tells that the stored edits of a clip in the table cannot be read", async ({ app, page }) => {
  await app.openStartPage();
  await storeRecord(app, sample("curved-walk"), "{");
  await app.drop(sample("curved-walk"), sample("bowling"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await expect(page.getByRole("row", { name: /curved-walk/ })).toContainText("cannot be read");
});
