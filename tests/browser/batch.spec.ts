/** Batches from several files, a folder or an archive. */

import { mkdirSync, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { strToU8, unzipSync, Zip, ZipDeflate, zipSync } from "fflate";
import { type App, expect, test } from "./app";
import { bad, clip, good, type Payload, sample } from "./clips";
import { readLabels } from "./labels";
import { atEachSize } from "./viewports";

const table = (app: App) => app.page.getByRole("table", { name: /clips$/ });
const row = (app: App, name: string) =>
  table(app)
    .getByRole("row")
    .filter({ has: app.page.getByRole("button", { name, exact: true }) });
const names = (app: App) =>
  table(app)
    .getByRole("rowheader")
    .locator(".clip-name")
    .evaluateAll((buttons) => buttons.map((button) => button.textContent));

async function waitForBatch(app: App) {
  await expect(app.page.getByText(/^All processed/)).toBeVisible();
}

const zip = (name: string, files: Record<string, Payload | string>): Payload => ({
  name,
  mimeType: "application/zip",
  buffer: Buffer.from(
    zipSync(
      Object.fromEntries(
        Object.entries(files).map(([path, file]) => [
          path,
          typeof file === "string" ? strToU8(file) : new Uint8Array(file.buffer),
        ]),
      ),
    ),
  ),
});

/** Returns a file of an unpacked archive. */
function savedText(files: Record<string, Uint8Array>, name: string) {
  const bytes = files[name] ?? new Uint8Array();
  return { name, bytes, text: Buffer.from(bytes).toString() };
}

test("the titles of columns are above their values and not cut", async ({ app }) => {
  await app.openStartPage();
  await app.drop(sample("bowling"), sample("curved-walk"));
  await waitForBatch(app);
  const faults = await table(app).evaluate((element) => {
    const rightOf = (cell: Element) => {
      const text = document.createRange();
      text.selectNodeContents(cell.querySelector("button > span") ?? cell);
      return text.getBoundingClientRect().right;
    };
    const titles = [...element.querySelectorAll("thead th")].slice(1);
    const values = [...element.querySelectorAll("tbody tr:first-child td")];
    return titles.flatMap((title, i) => {
      const value = values[i];
      const shift = value?.textContent ? rightOf(title) - rightOf(value) : 0;
      return Math.abs(shift) < 1.5 ? [] : [`${title.textContent}: ${shift}`];
    });
  });
  expect(faults).toEqual([]);
});

test("lists several files in a table and reports invalid ones", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(sample("bowling"), bad("ragged-row"), sample("curved-walk"), good("no-motion"));
  await waitForBatch(app);
  await expect(page.getByRole("heading", { name: "4 clips" })).toBeVisible();
  expect(await names(app)).toEqual([
    "bowling.bvh",
    "ragged-row.bvh",
    "curved-walk.bvh",
    "no-motion.bvh",
  ]);
  await expect(row(app, "curved-walk.bvh")).toContainText(/245\s*120 Hz\s*2.04 s/);
  await expect(row(app, "ragged-row.bvh")).toContainText("row");
  await expect(row(app, "no-motion.bvh")).toContainText("–");
  // All of a row opens its clip.
  await row(app, "curved-walk.bvh").getByRole("cell").last().click();
  await app.waitForClip("curved-walk.bvh");
  await expect(table(app)).toBeHidden();
  expect((await app.result("Left")).plants + (await app.result("Right")).plants).toBe(5);
  await page.getByRole("button", { name: "4 clips" }).click();
  await expect(row(app, "curved-walk.bvh").getByRole("cell").nth(4)).toHaveText("5");
  // Opening an invalid file shows the full error.
  await row(app, "ragged-row.bvh").getByRole("button").click();
  await expect(app.alert).toContainText("At line 70");
  await expect(app.alert).toContainText("curved-walk.bvh is still open");
  await app.alert.getByRole("button", { name: "Dismiss" }).click();
  await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
  await expect(app.playhead).toBeVisible();
});

test("unpacks an archive and saves all labels in another one", async ({ app, page }) => {
  await app.openStartPage();
  const archive = zip("walks.zip", {
    "a/walk.bvh": sample("curved-walk"),
    "b/walk.bvh": good("plain"),
    "__MACOSX/._walk.bvh": "metadata",
    "readme.txt": "not a clip",
  });
  await app.drop(archive);
  await waitForBatch(app);
  expect(await names(app)).toEqual(["a/walk.bvh", "b/walk.bvh"]);
  const saved = await app.download(() => page.getByRole("button", { name: /^Save all/ }).click());
  expect(saved.name).toBe("labels.zip");
  const files = unzipSync(saved.bytes);
  const kinds = ["plants.json", "frames.csv", "intervals.csv", "events.csv"];
  const segments = ["segments.json", "segments.csv"];
  const expected = ["walk", "walk-2"].flatMap((name) =>
    [...kinds, ...segments].map((kind) => `${name}.${kind}`),
  );
  // Twelve frames cannot be segmented, but they are labelled.
  const found = Object.keys(files);
  expect(found).toEqual(expect.arrayContaining(expected.filter((name) => !/-2\.seg/.test(name))));
  const lines = Buffer.from(files["table.csv"] ?? [])
    .toString()
    .split("\n");
  expect(lines[0]).toMatch(/^file,frames,rate_hz,duration_s,/);
  expect(lines[1]).toMatch(/^a\/walk\.bvh,245,120\.0\d*,.*,walk$/);
  expect(lines[2]).toMatch(/^b\/walk\.bvh,12,.*,walk-2$/);
  const rows = Buffer.from(files["walk.frames.csv"] ?? [])
    .toString()
    .trim()
    .split("\n");
  expect(rows).toHaveLength(246);
});

test("opens an archive with one clip and reports broken or empty archives", async ({ app }) => {
  await app.openStartPage();
  await app.drop(zip("one.zip", { "curved-walk.bvh": sample("curved-walk") }));
  await app.waitForClip("curved-walk.bvh");
  const complete = zip("broken.zip", { "curved-walk.bvh": sample("curved-walk") });
  await app.drop({ ...complete, buffer: complete.buffer.subarray(0, 200) });
  await expect(app.alert).toContainText("broken.zip could not be opened");
  await app.alert.getByRole("button", { name: "Dismiss" }).click();
  await app.drop(zip("none.zip", { "readme.txt": "nothing" }));
  await expect(app.alert).toContainText("contains no BVH file");
  await expect(app.alert).toContainText("curved-walk.bvh is still open");
});

test("refuses an archive that exceeds the size limit when unpacked", async ({ app }) => {
  const chunks: Uint8Array[] = [];
  const bomb = new Zip((_, chunk) => chunks.push(chunk));
  const entry = new ZipDeflate("bomb.bvh", { level: 1 });
  bomb.add(entry);
  const zeros = new Uint8Array(2 ** 20);
  for (let i = 0; i < 300; i++) entry.push(zeros, i === 299);
  bomb.end();
  await app.openSample("curved-walk");
  await app.drop({ name: "bomb.zip", mimeType: "", buffer: Buffer.concat(chunks) });
  await expect(app.alert).toContainText("unpacks to more than");
  await expect(app.alert).toContainText("curved-walk.bvh is still open");
});

test("opens the clips of a folder and its subfolders", async ({ app, page }) => {
  const folder = mkdtempSync(join(tmpdir(), "clips-"));
  mkdirSync(join(folder, "deep"));
  writeFileSync(join(folder, "b10.bvh"), good("plain").buffer);
  writeFileSync(join(folder, "b9.bvh"), good("plain").buffer);
  writeFileSync(join(folder, "deep", "walk.BVH"), sample("curved-walk").buffer);
  writeFileSync(join(folder, "notes.txt"), "not a clip");
  await app.openStartPage();
  const system = await page.context().newCDPSession(page);
  const data = { items: [], files: [folder], dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"] as const) {
    await system.send("Input.dispatchDragEvent", { type, x: 700, y: 400, data });
  }
  await waitForBatch(app);
  expect(await names(app)).toEqual(["b9.bvh", "b10.bvh", "walk.BVH"]);
});

test("assigns dropped labels to clips by file name", async ({ app }) => {
  const truth = (name: string) => ({
    ...sample("curved-walk"),
    name,
    buffer: clip("samples/curved-walk.json").buffer,
  });
  await app.openStartPage();
  await app.drop(
    sample("curved-walk"),
    sample("bowling"),
    truth("curved-walk.json"),
    truth("unmatched.json"),
  );
  await waitForBatch(app);
  await expect(row(app, "unmatched.json")).toContainText(
    "No clip of this drop has a matching file name",
  );
  await row(app, "curved-walk.bvh").getByRole("button", { name: "curved-walk.bvh" }).click();
  await app.waitForClip("curved-walk.bvh");
  await app.tab("Score");
  await expect(app.panel).toContainText("curved-walk.json");
});

test("compares clips of the same name with the labels of their own folder", async ({ app }) => {
  const truth = clip("samples/curved-walk.json");
  const none = JSON.stringify({ left: Array(245).fill(0), right: Array(245).fill(0) });
  const walk = sample("curved-walk");
  await app.openStartPage();
  await app.drop(
    zip("walks.zip", {
      "a/walk.bvh": walk,
      "a/walk.json": none,
      "b/walk.bvh": walk,
      "b/walk.json": truth,
    }),
  );
  await waitForBatch(app);
  const score = (name: string) => row(app, name).locator('[data-key="agreement_0_1_s"]');
  const scoreOf = async (name: string) => Number.parseFloat(await score(name).innerText());
  expect(await scoreOf("a/walk.bvh")).toBeLessThan(70);
  expect(await scoreOf("b/walk.bvh")).toBeGreaterThan(90);
  const shown = await score("b/walk.bvh").innerText();
  await row(app, "b/walk.bvh").getByRole("button").first().click();
  await app.waitForClip("b/walk.bvh");
  await app.tab("Score");
  await expect(app.panel).toContainText(shown.replace(" %", ""));
});

test("a clip whose name another one has is shown with its folder everywhere", async ({
  app,
  page,
}) => {
  const walk = sample("curved-walk");
  await app.openStartPage();
  await app.drop(
    zip("walks.zip", {
      "the first session of the day/a/walk.bvh": walk,
      "b/walk.bvh": bad("not-a-number"),
      "c/walk.bvh": good("no-motion"),
    }),
  );
  await waitForBatch(app);
  await row(app, "the first session of the day/a/walk.bvh").getByRole("button").first().click();
  await app.waitForClip("the first session of the day/a/walk.bvh");
  await expect(app.head.locator("strong")).toHaveText("the first session of the day/a/walk.bvh");
  await test.step("in little space, the folder is cut before the name", async () => {
    await page.setViewportSize({ width: 390, height: 844 });
    const cut = (part: string) =>
      app.head
        .getByText(part, { exact: true })
        .evaluate(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth);
    expect(await cut("walk.bvh")).toBe(false);
    expect(await cut("the first session of the day/a/")).toBe(true);
    await page.setViewportSize({ width: 1440, height: 900 });
  });
  await expect(
    page.getByRole("img", { name: "Skeleton of the first session of the day/a/walk.bvh" }),
  ).toBeVisible();
  await app.head.getByRole("button", { name: "Share" }).click();
  await expect(app.dialog).toHaveAccessibleName("Share the first session of the day/a/walk.bvh");
  await page.keyboard.press("Escape");
  await app.head.getByRole("button", { name: "3 clips" }).click();
  await page
    .getByRole("button", {
      name: "c/walk.bvh side by side with the first session of the day/a/walk.bvh",
    })
    .focus();
  await page.keyboard.press("Enter");
  await row(app, "b/walk.bvh").getByRole("button").first().click();
  await expect(app.alert.getByRole("heading")).toHaveText("b/walk.bvh could not be opened");
  await expect(app.alert).toContainText("the first session of the day/a/walk.bvh is still open");
  await page
    .getByRole("button", { name: "Back to the first session of the day/a/walk.bvh" })
    .click();
  const shown = page.getByRole("list", { name: "Comparison clips" });
  await expect(shown.getByRole("listitem")).toHaveText(["c/walk.bvh"]);
});

test("a row that is opened leniently has the labels and notices of that, also in saved files", async ({
  app,
  page,
}) => {
  const damaged = {
    ...sample("curved-walk"),
    name: "damaged.bvh",
    buffer: Buffer.from(
      sample("curved-walk")
        .buffer.toString()
        .replace(/\S+\s*$/, "abc\n"),
    ),
  };
  await app.openStartPage();
  await app.drop(sample("bowling"), damaged, {
    ...clip("samples/curved-walk.json"),
    name: "damaged.json",
  });
  await waitForBatch(app);
  await expect(row(app, "damaged.bvh")).toContainText(/Expected a number/);
  await row(app, "damaged.bvh").getByRole("button").first().click();
  await app.alert.getByRole("button", { name: "Open leniently" }).click();
  await app.waitForClip("damaged.bvh");
  // As a clip of the table, it replaces the table and is compared with its labels.
  await expect(table(app)).toBeHidden();
  await expect(page.getByRole("tab", { name: "Score" })).toBeVisible();
  const notices = await app.head.getByRole("button", { name: /notice/ }).innerText();
  const plants = (await app.result("Left")).plants + (await app.result("Right")).plants;
  await app.head.getByRole("button", { name: "2 clips" }).click();
  await expect(page.getByText("All processed")).not.toContainText("failed");
  const cell = (key: string) => row(app, "damaged.bvh").locator(`[data-key="${key}"]`);
  await expect(cell("plants")).toHaveText(String(plants));
  await expect(cell("notices")).toHaveText(`${Number.parseInt(notices, 10)}`);
  await expect(cell("agreement_0_1_s")).toHaveText(/^(9\d\.\d|100\.0) %$/);
  const saved = await app.download(() => page.getByRole("button", { name: /^Save all/ }).click());
  const files = unzipSync(saved.bytes);
  const { left, right } = readLabels(savedText(files, "damaged.plants.json"));
  expect([...(left.contact ?? []), ...(right.contact ?? [])]).toHaveLength(plants);
  expect(savedText(files, "table.csv").text).not.toContain("expected a number");
  // It is opened in the same way again.
  await row(app, "bowling.bvh").getByRole("button").first().click();
  await app.waitForClip("bowling.bvh");
  await page.goBack();
  await page.goBack();
  await app.waitForClip("damaged.bvh");
  await expect(app.alert).toBeHidden();
});

test("processes a thousand files without blocking the page", async ({ app, page }) => {
  await app.openStartPage();
  const { buffer } = good("plain");
  const many = Array.from({ length: 1000 }, (_, i) => ({
    name: `clip-${i + 1}.bvh`,
    mimeType: "text/plain",
    buffer: i === 500 ? Buffer.from("HIERARCHY") : buffer,
  }));
  await app.drop(...many);
  await expect(page.getByRole("heading", { name: /^1.000 clips$/ })).toBeVisible();
  // The batch can be stopped and resumed.
  await page.getByRole("button", { name: "Stop" }).click();
  await page.getByRole("button", { name: "Resume" }).click();
  await expect(page.getByText(/^All processed/)).toBeVisible({ timeout: 60_000 });
  expect(await table(app).getByRole("row").count()).toBeLessThan(60);
  await page.getByRole("searchbox", { name: "Filter by name" }).fill("failed");
  expect(await names(app)).toEqual(["clip-501.bvh"]);
  await page.getByRole("searchbox", { name: "Filter by name" }).fill("");
  await page.getByRole("button", { name: "clip-3.bvh", exact: true }).click();
  await app.waitForClip("clip-3.bvh");
});

test("a running batch can be stopped but not resumed", async ({ app, page }) => {
  await app.openStartPage();
  const shown = await page.evaluateHandle(() => {
    const texts = new Set<string>();
    const addButtons = () => {
      for (const { innerText } of document.querySelectorAll<HTMLElement>(".batch-head .button"))
        texts.add(innerText);
    };
    new MutationObserver(addButtons).observe(document.body, { childList: true, subtree: true });
    return texts;
  });
  await app.drop(sample("bowling"), sample("curved-walk"), sample("frog-jumps"));
  await waitForBatch(app);
  const texts = await shown.evaluate((set) => [...set]);
  expect(texts).toContain("Stop");
  expect(texts).not.toContain("Resume");
});

test("applies stored edits and changed options in the table", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect(app.panel.getByText("edited")).toHaveCount(0);
  await app.drop(sample("curved-walk"), sample("bowling"));
  await waitForBatch(app);
  await expect(row(app, "curved-walk.bvh")).toContainText("edited");
  await expect(row(app, "curved-walk.bvh").getByRole("cell").nth(4)).toHaveText("4");
  await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
  await app.tab("Detect");
  await page.getByRole("combobox", { name: "Method" }).selectOption("paper");
  await page.getByRole("button", { name: "2 clips" }).click();
  await page.getByRole("button", { name: "Process again" }).click();
  await expect(page.getByText("All processed · Paper")).toBeVisible();
});

test("is processed again with another segmentation, but not if the options are as before", async ({
  app,
  page,
}) => {
  await app.openStartPage();
  await app.drop(sample("bowling"), sample("curved-walk"));
  await waitForBatch(app);
  await row(app, "bowling.bvh").getByRole("button").first().click();
  await app.waitForClip("bowling.bvh");
  const again = page.getByRole("button", { name: "Process again" });
  const choose = async (tab: "Detect" | "Segment", ...methods: string[]) => {
    await app.tab(tab);
    for (const method of methods)
      await page.getByRole("combobox", { name: "Method" }).selectOption(method);
  };
  const showTable = () => page.getByRole("button", { name: "2 clips" }).click();
  await choose("Detect", "paper", "robust");
  await choose("Segment", "lsd", "auto");
  await showTable();
  await expect(again).toBeHidden();
  const segments = row(app, "bowling.bvh").locator('[data-key="segments"]');
  const before = await segments.innerText();
  await page.getByRole("button", { name: "Back to bowling.bvh" }).click();
  await choose("Segment", "lsd");
  const count = async () => String((await app.segments()).length);
  await expect.poll(count).not.toBe(before);
  const after = await count();
  await showTable();
  await again.click();
  await expect(again).toBeHidden();
  await waitForBatch(app);
  await expect(segments).toHaveText(after);
});

test("scores clips with the labels that were dropped with them", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(sample("bowling"), sample("frog-jumps"), clip("samples/frog-jumps.json"));
  await waitForBatch(app);
  await expect(row(app, "frog-jumps.bvh")).toContainText(/\d\d\.\d %/);
  await expect(row(app, "bowling.bvh")).not.toContainText(/\d\d\.\d %/);
  await expect(page.getByRole("columnheader", { name: "Score" })).toHaveText("Score ± 0.1 s");
});

test("labels that are dropped on the table are compared with their row, not with the hidden clip", async ({
  app,
  page,
}) => {
  const score = row(app, "limp-to-run.bvh").locator('[data-key="agreement_0_1_s"]');
  await app.openSample("curved-walk");
  await app.drop(sample("bowling"), sample("limp-to-run"));
  await waitForBatch(app);
  await expect(score).toHaveText("–");
  await app.drop(clip("samples/limp-to-run.json"));
  await expect(score).toHaveText(/^9\d\.\d %$/);
  await expect(app.toast).toHaveText(/1 clip was compared with the dropped labels/);
  await expect(app.alert).toBeHidden();
  await app.drop(clip("samples/frog-jumps.json"));
  await expect(app.alert).toContainText("No clip of the table has a matching file name");
  await app.alert.getByRole("button", { name: "Dismiss" }).click();
  await row(app, "limp-to-run.bvh").getByRole("button").first().click();
  await app.waitForClip("limp-to-run.bvh");
  await expect(page.getByRole("tab", { name: "Score" })).toBeVisible();
});

test("the row of the open clip follows its edits", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(sample("curved-walk"), sample("bowling"));
  await waitForBatch(app);
  const plants = row(app, "curved-walk.bvh").getByRole("cell").nth(4);
  await expect(plants).toHaveText("5");
  await row(app, "curved-walk.bvh").getByRole("button").first().click();
  await app.waitForClip("curved-walk.bvh");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect(app.head.getByRole("button", { name: "edited" })).toBeVisible();
  await page.getByRole("button", { name: "2 clips" }).click();
  await expect(plants).toHaveText("4");
  await expect(row(app, "curved-walk.bvh")).toContainText("edited");
});

test("Back restores the labels that were dropped with a clip", async ({ app, page }) => {
  await app.openStartPage();
  await app.drop(sample("bowling"), sample("frog-jumps"), clip("samples/frog-jumps.json"));
  await waitForBatch(app);
  await row(app, "frog-jumps.bvh").getByRole("button").first().click();
  await expect(page.getByRole("tab", { name: "Score" })).toBeVisible();
  await page.getByRole("button", { name: "2 clips" }).click();
  await row(app, "bowling.bvh").getByRole("button").first().click();
  await app.waitForClip("bowling.bvh");
  await expect(page.getByRole("tab", { name: "Score" })).toBeHidden();
  await page.goBack();
  await expect(table(app)).toBeVisible();
  await page.goBack();
  await app.waitForClip("frog-jumps.bvh");
  await expect(page.getByRole("tab", { name: "Score" })).toBeVisible();
});

test("Back leads from a clip to the table, and from there to the page before it", async ({
  app,
  page,
}) => {
  await app.openSample("frog-jumps");
  await app.drop(sample("bowling"), sample("curved-walk"));
  await waitForBatch(app);
  await row(app, "bowling.bvh").getByRole("button").first().click();
  await app.waitForClip("bowling.bvh");
  await page.goBack();
  await expect(table(app)).toBeVisible();
  await row(app, "curved-walk.bvh").getByRole("button").first().click();
  await app.waitForClip("curved-walk.bvh");
  // A table that is closed again leaves no entry that Back would stop at.
  await page.getByRole("button", { name: "2 clips" }).click();
  await page.getByRole("button", { name: "Back to curved-walk.bvh" }).click();
  await expect(table(app)).toBeHidden();
  await page.goBack();
  await expect(table(app)).toBeVisible();
  await page.goBack();
  await app.waitForClip("frog-jumps.bvh");
  await expect(table(app)).toBeHidden();
});

test("marks clips as checked until their labels are computed in another way", async ({
  app,
  page,
}) => {
  const checkBox = (name: string) =>
    table(app).getByRole("checkbox", { name: `${name} is checked` });
  const openBatch = async () => {
    await app.openStartPage();
    await app.drop(sample("bowling"), sample("curved-walk"), sample("frog-jumps"));
    await waitForBatch(app);
  };
  await openBatch();
  await checkBox("bowling.bvh").check();
  await checkBox("curved-walk.bvh").check();
  await checkBox("curved-walk.bvh").uncheck();
  await openBatch();
  await expect(checkBox("bowling.bvh")).toBeChecked();
  await expect(checkBox("curved-walk.bvh")).not.toBeChecked();
  await expect(page.getByRole("button", { name: /^Review 2/ })).toBeVisible();
  await row(app, "bowling.bvh").getByRole("button").first().click();
  await app.waitForClip("bowling.bvh");
  await app.tab("Detect");
  await page.getByRole("combobox", { name: "Method" }).selectOption("paper");
  await page.getByRole("button", { name: "3 clips" }).click();
  await page.getByRole("button", { name: "Process again" }).click();
  await expect(page.getByText("All processed · Paper")).toBeVisible();
  await expect(checkBox("bowling.bvh")).not.toBeChecked();
});

test("a filter that hides all clips is stated in the table, and ends when other files are dropped", async ({
  app,
  page,
}) => {
  const filter = page.getByRole("searchbox", { name: "Filter by name" });
  await app.openStartPage();
  await app.drop(sample("bowling"), sample("curved-walk"));
  await waitForBatch(app);
  await filter.fill("jumps");
  await expect(table(app)).toContainText("No clip matches the filter “jumps”.");
  await table(app).getByRole("button", { name: "Show all clips" }).click();
  expect(await names(app)).toEqual(["bowling.bvh", "curved-walk.bvh"]);
  await filter.fill("bowling");
  await app.drop(sample("frog-jumps"), sample("skipping"));
  await expect(page.getByRole("heading", { name: "2 clips", exact: true })).toBeVisible();
  await expect(filter).toHaveValue("");
  await waitForBatch(app);
  expect(await names(app)).toEqual(["frog-jumps.bvh", "skipping.bvh"]);
});

atEachSize(() => {
  test("sorts and filters the table", async ({ app, page }) => {
    await app.openStartPage();
    await app.drop(
      sample("bowling"),
      sample("curved-walk"),
      bad("ragged-row"),
      sample("frog-jumps"),
    );
    await waitForBatch(app);
    const frames = page.getByRole("columnheader", { name: "Frames" });
    await frames.getByRole("button").click();
    await expect(frames).toHaveAttribute("aria-sort", "ascending");
    const up = await names(app);
    expect(up.at(-1)).toBe("ragged-row.bvh");
    await frames.getByRole("button").click();
    await expect(frames).toHaveAttribute("aria-sort", "descending");
    expect(await names(app)).toEqual([...up.slice(0, 3).reverse(), "ragged-row.bvh"]);
    await page.getByRole("searchbox", { name: "Filter by name" }).fill("walk");
    expect(await names(app)).toEqual(["curved-walk.bvh"]);
    await page.getByRole("searchbox", { name: "Filter by name" }).fill("failed");
    expect(await names(app)).toEqual(["ragged-row.bvh"]);
  });

  test("reviews the least certain clip first", async ({ app, page }) => {
    await app.openStartPage();
    await app.drop(
      sample("bowling"),
      sample("curved-walk"),
      sample("frog-jumps"),
      bad("ragged-row"),
    );
    await waitForBatch(app);
    await expect(page.getByText("All processed, 1 failed")).toBeVisible();
    await page.getByRole("columnheader", { name: "Confidence" }).getByRole("button").click();
    const order = (await names(app)).slice(0, 3);
    await page.getByRole("button", { name: /^Review 3/ }).click();
    await app.waitForClip(order[0] ?? "");
    await page.keyboard.press("c");
    await expect(app.head.getByRole("checkbox", { name: "Checked" })).toBeChecked();
    await page.keyboard.press("n");
    await app.waitForClip(order[1] ?? "");
    await app.head.getByRole("checkbox", { name: "Checked" }).check();
    await app.head.getByRole("button", { name: /^Next/ }).click();
    await app.waitForClip(order[2] ?? "");
    await page.getByRole("button", { name: "4 clips" }).click();
    await page.getByRole("searchbox", { name: "Filter by name" }).fill("unchecked");
    await expect(page.getByRole("heading", { name: "2 of 4 clips" })).toBeVisible();
  });
});

test("equal actions of all clips have the same letter and share a name", async ({ app, page }) => {
  await app.openStartPage();
  const copy = (name: string, from: string) => ({ ...sample(from), name: `${name}.bvh` });
  await app.drop(copy("a", "frog-jumps"), copy("b", "skipping"), copy("c", "limp-to-run"));
  await waitForBatch(app);
  const open = async (name: string) => {
    await page.getByRole("button", { name: `${name}.bvh`, exact: true }).click();
    await app.waitForClip(`${name}.bvh`);
    await app.segments();
  };
  const letters = () => app.panel.locator(".action-letter").allInnerTexts();
  const nameOf = (segment: number) =>
    app.panel.getByRole("textbox", { name: `Name of segment ${segment}`, exact: true });
  const back = () => page.getByRole("button", { name: "3 clips" }).click();
  const saved = async () => {
    const { bytes } = await app.download(() =>
      page.getByRole("button", { name: /^Save all/ }).click(),
    );
    const files = unzipSync(bytes);
    return ["a", "b", "c"].map((name) => {
      const { segments } = JSON.parse(Buffer.from(files[`${name}.segments.json`] ?? []).toString());
      return segments as { action: string; label: string }[];
    });
  };
  // The Clip tab has the same slides as the table.
  const slides = row(app, "c.bvh").getByRole("cell", { name: /cm$/ });
  const [mean = "", worst = ""] = await slides.allInnerTexts();
  await open("c");
  await app.tab("Clip");
  const measured = app.panel.getByRole("table", { name: "Foot skate" }).getByRole("cell");
  await expect(measured).toHaveText([mean, worst]);
  await back();
  const [frog = [], skip = [], limp = []] = await saved();
  expect(frog[0]?.action).toBe("A");
  // The actor stands still after frog jumps and before skipping.
  expect(skip[0]?.action).toBe(frog.at(-1)?.action);
  expect(new Set([...frog, ...skip, ...limp].map(({ action }) => action)).size).toBeGreaterThan(3);
  await open("b");
  const shown = skip.map(({ action }) => action);
  await expect.poll(letters).toEqual(shown);
  // What the letters mean is explained at the list, at the lane, and with the marks of the timeline.
  await expect(
    app.panel.getByText("The same action has the same letter and name in all clips"),
  ).toBeVisible();
  const lane = await app.tracks.boundingBox();
  if (!lane) throw new Error("The timeline has no canvas.");
  const readout = app.timeline.locator(".pointed-frame");
  await expect(async () => {
    for (let y = lane.height - 30; y > 40 && !/action/.test(await readout.innerText()); y -= 6)
      await page.mouse.move(lane.x + 0.5 * lane.width, lane.y + y);
    await expect(readout).toHaveText(/action [A-Z], as in all clips of the table$/, {
      timeout: 100,
    });
  }).toPass();
  await app.timeline.getByRole("button", { name: "Tracks" }).click();
  await expect(
    app.timeline.getByText("Segments of the same action have the same letter"),
  ).toBeVisible();
  await page.keyboard.press("Escape");
  expect((await app.saveSegments("Segments")).text).toContain(`"action": "${shown[1]}"`);
  await nameOf(1).fill("stand");
  await back();
  await open("a");
  await expect(nameOf(frog.length)).toHaveValue("stand");
  await expect(nameOf(1)).toHaveValue("");
  // A name of the clip itself takes precedence.
  await nameOf(frog.length).fill("wait");
  await back();
  await open("b");
  await expect(nameOf(1)).toHaveValue("stand");
  await back();
  const [frogLabels, skipLabels] = (await saved()).map((list) => list.map(({ label }) => label));
  expect(frogLabels?.at(-1)).toBe("wait");
  expect(skipLabels?.[0]).toBe("stand");
  // A removed name is removed everywhere.
  await open("b");
  await nameOf(1).fill("");
  await expect(nameOf(1)).toHaveValue("wait");
});
