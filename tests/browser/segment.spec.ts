import { unzipSync } from "fflate";
import { type App, expect, test } from "./app";
import { clip, file, good, repeated, sample, twoPeople } from "./clips";
import { methodNames } from "./core";
import { readTable } from "./labels";

interface SegmentsDocument {
  format: string;
  frames: number;
  rate: number;
  method: { name: string };
  segments: { start: number; end: number; kind: string; label: string; source: string }[];
}

const read = (text: string): SegmentsDocument => JSON.parse(text);

const menu = (app: App) => app.panel.getByRole("combobox", { name: "Method" });
const progress = (app: App) => app.page.getByText("Segmenting");
const name = (app: App, number: number) =>
  app.panel.getByRole("textbox", { name: `Name of segment ${number}`, exact: true });

/** Returns the middle of the segment bar at a position, found by clicking upwards. */
async function findSegmentBar(app: App, position: number): Promise<{ x: number; y: number }> {
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const x = box.x + position * box.width;
  for (let y = box.y + box.height - 40; y > box.y + 150; y -= 3) {
    await app.page.mouse.click(x, y);
    if (await app.timeline.getByText("Loop segment").isVisible()) return { x, y: y - 8 };
  }
  throw new Error("No bar of a segment was hit.");
}

test("segments a clip without gaps when it is opened", async ({ app }) => {
  await app.openSample("limp-to-run");
  const segments = await app.segments();
  expect(segments.length).toBeGreaterThan(1);
  let end = 0;
  for (const { start, length } of segments) {
    expect(start).toBeCloseTo(end, 1);
    end = start + length;
  }
  expect(end).toBeCloseTo(31, 1);
  const table = app.timeline.getByRole("table", { name: `${segments.length} segments` });
  await expect(table.getByRole("row")).toHaveCount(segments.length + 1);
});

test("offers the segmentation methods of the core, which segment a clip", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.tab("Segment");
  const expected = methodNames().segment;
  await expect(menu(app)).toHaveValue(expected[0] ?? "");
  const names = await menu(app)
    .locator("option")
    .evaluateAll((all) => all.map((option) => (option as HTMLOptionElement).value));
  expect(names).toEqual(expected);
  const lines = new Set<string>();
  for (const method of names) {
    await menu(app).selectOption(method);
    await expect(progress(app)).toBeHidden();
    lines.add(await page.locator("#segment-method-line").innerText());
    expect(read((await app.saveSegments("Segments")).text).method.name).toBe(method);
    expect((await app.segments()).length).toBeGreaterThan(0);
  }
  expect(lines.size).toBe(names.length);
});

test("shows the options of each method", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.tab("Segment");
  for (const [method, dims, residual, template, published] of [
    ["auto", false, false, false, false],
    ["lsd", false, false, true, true],
    ["mvu", true, true, false, true],
    ["pca-tail", true, false, false, false],
    ["ppca", false, false, false, true],
  ] as const) {
    await menu(app).selectOption(method);
    const select = (label: string) => app.panel.getByRole("combobox", { name: label });
    await expect(select("Dimensions d")).toBeVisible({ visible: dims });
    await expect(select("Residual")).toBeVisible({ visible: residual });
    await expect(select("Template")).toBeVisible({ visible: template });
    const check = app.panel.getByRole("checkbox", { name: "As published" });
    await expect(check).toBeVisible({ visible: published });
  }
  await menu(app).selectOption("lsd");
  await app.pressRuler(0.5);
  const frame = await app.frame();
  const template = app.panel.getByRole("combobox", { name: "Template" });
  await template.selectOption({ label: "Current frame" });
  await expect(template).toHaveValue(String(frame));
  const { method } = read((await app.saveSegments("Segments")).text);
  expect(method).toMatchObject({ template: String(frame) });
  await page.keyboard.press("Home");
});

test("loops a segment by click on its bar or list item", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const segments = await app.segments();
  await app.pressRuler(0.9);
  await findSegmentBar(app, 0.3);
  await expect(app.timeline.getByText("Loop segment 1")).toBeVisible();
  expect(await app.frame()).toBe(0);
  const second = app.panel.getByRole("button", { name: /^Loop segment 2/ });
  await second.click();
  await expect(second).toHaveAttribute("aria-pressed", "true");
  expect(await app.frame()).toBe(Math.round((segments[1]?.start ?? 0) * 24));
  // Playback repeats the segment.
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.getByRole("combobox", { name: "Speed" }).selectOption("4");
  await page.keyboard.press("Space");
  const [from, to] = [segments[1]?.start ?? 0, (segments[2]?.start ?? 31) + 0.1];
  const [least, greatest] = await page.evaluate(async () => {
    const frameNow = () =>
      Number(document.querySelector("[role=slider]")?.getAttribute("aria-valuenow"));
    let frame = frameNow();
    let [least, greatest, rounds] = [frame, frame, 0];
    while (rounds < 2) {
      await new Promise(requestAnimationFrame);
      const next = frameNow();
      if (next < frame) rounds++;
      [least, greatest, frame] = [Math.min(least, next), Math.max(greatest, next), next];
    }
    return [least, greatest] as const;
  });
  expect(least / 24).toBeGreaterThanOrEqual(from - 0.1);
  expect(greatest / 24).toBeLessThanOrEqual(to);
});

test("steps through cuts, loops and renames segments by key", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  const { segments } = read((await app.saveSegments("Segments")).text);
  await app.tab("Detect");
  const cuts = segments.slice(1).map(({ start }) => start);
  for (const cut of [...cuts, 743]) {
    await page.keyboard.press("]");
    expect(await app.frame()).toBe(cut);
  }
  for (const cut of [...cuts.reverse(), 0]) {
    await page.keyboard.press("[");
    expect(await app.frame()).toBe(cut);
  }
  await page.keyboard.press("]");
  await page.keyboard.press("s");
  await expect(app.timeline.getByText("Loop segment 2")).toBeVisible();
  await expect(app.playhead).toHaveAttribute("aria-valuetext", /segment 2/);
  await page.keyboard.press("Enter");
  await expect(name(app, 2)).toBeFocused();
  await page.keyboard.type("l s ]");
  await expect(name(app, 2)).toHaveValue("l s ]");
  await page.keyboard.press("Escape");
  await expect(name(app, 2)).toHaveValue("");
  await page.keyboard.press("?");
  await expect(app.dialog).toContainText("Previous, next cut");
});

test("shows a segment name on the bar, in files and with other methods", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.tab("Segment");
  const before = await app.tracks.screenshot();
  const { x, y } = await findSegmentBar(app, 0.3);
  await page.keyboard.press("Shift+l");
  // A click on the ruler separates the clicks on the bar.
  await app.pressRuler(0.3);
  await page.mouse.dblclick(x, y);
  await expect(name(app, 1)).toBeFocused();
  await page.keyboard.type("Limping, slowly");
  await page.keyboard.press("Enter");
  await expect(name(app, 1)).not.toBeFocused();
  expect(await app.tracks.screenshot()).not.toEqual(before);
  await menu(app).selectOption("lsd");
  await expect(app.panel.getByRole("combobox", { name: "Template" })).toBeVisible();
  await menu(app).selectOption("auto");
  await expect(name(app, 1)).toHaveValue("Limping, slowly");
  const { segments } = read((await app.saveSegments("Segments")).text);
  expect(segments[0]).toMatchObject({ label: "Limping, slowly", source: "edited" });
  expect(segments[1]).toMatchObject({ label: "", source: "auto" });
  await app.drop(sample("bowling"));
  await app.waitForClip("bowling.bvh");
  await expect(name(app, 1)).toHaveValue("");
});

test("saves the segments of a method that is still running under their own names", async ({
  app,
}) => {
  await app.openSample("limp-to-run");
  await app.tab("Segment");
  await menu(app).selectOption("lsd");
  await expect(name(app, 2)).toHaveAttribute("placeholder", /^Motifs/);
  await menu(app).selectOption("mvu");
  const { method, segments } = read((await app.saveSegments("Segments")).text);
  expect(method.name).toBe("mvu");
  for (const segment of segments) expect(segment).toMatchObject({ label: "", source: "auto" });
});

test("saves segments as JSON, CSV and BABEL", async ({ app }) => {
  await app.openSample("limp-to-run");
  const listed = await app.segments();
  const saved = await app.saveSegments("Segments");
  expect(saved.name).toBe("limp-to-run.segments.json");
  const document = read(saved.text);
  expect(document).toMatchObject({ format: "plantigrade-segments", frames: 744 });
  const starts = document.segments.map(({ start }) => (start / 24).toFixed(2));
  expect(starts).toEqual(listed.map(({ start }) => start.toFixed(2)));
  expect(document.segments.at(-1)?.end).toBe(744);
  const table = await app.saveSegments("Table");
  expect(table.name).toBe("limp-to-run.segments.csv");
  const rows = readTable(table).rows.map((row) => [Number(row.start_frame), Number(row.end_frame)]);
  expect(rows).toEqual(document.segments.map(({ start, end }) => [start, end]));
  const babel = await app.saveSegments("BABEL");
  expect(babel.name).toBe("limp-to-run.babel.json");
  expect(babel.text).toContain("frame_ann");
});

test("saves segments as BVH files that can be opened", async ({ app }) => {
  await app.openSample("limp-to-run");
  const { segments } = read((await app.saveSegments("Segments")).text);
  await name(app, 1).fill("a limp / walk");
  const saved = await app.saveSegments("Clips");
  expect(saved.name).toBe("limp-to-run.segments.zip");
  const files = Object.entries(unzipSync(saved.bytes));
  expect(files.map(([path]) => path)).toEqual(
    segments.map((_, i) => `limp-to-run-0${i + 1}${i === 1 ? "" : "-a-limp-walk"}.bvh`),
  );
  const texts = files.map(([, bytes]) => Buffer.from(bytes).toString());
  expect(texts.map((text) => Number(/^Frames: (\d+)$/m.exec(text)?.[1]))).toEqual(
    segments.map(({ start, end }) => end - start),
  );
  const [path = "", text = ""] = [files[1]?.[0], texts[1]];
  await app.drop(file(path, text));
  await app.waitForClip(path);
  await expect(app.head).toContainText("24 Hz");
});

for (const button of ["Segments", "Table", "BABEL"] as const) {
  test(`segments read back from ${button} agree with the segmentation`, async ({ app }) => {
    await app.openSample("limp-to-run");
    await app.tab("Segment");
    const tracks = await app.tracks.screenshot();
    const saved = await app.saveSegments(button);
    await app.drop(file(saved.name, saved.text));
    await expect(app.panel).toContainText(saved.name);
    for (const within of ["0.5", "1.0"]) {
      const row = app.panel.getByRole("row", { name: `± ${within} s` });
      await expect(row.getByRole("cell")).toHaveText(["100", "100", "100"]);
    }
    expect(await app.tracks.screenshot()).not.toEqual(tracks);
    await app.panel.getByRole("button", { name: "Remove", exact: true }).click();
    await expect.poll(() => app.tracks.screenshot()).toEqual(tracks);
  });
}

test("segments of one of two people agree when they are read back from any format", async ({
  app,
}) => {
  await app.openFile(twoPeople(sample("limp-to-run")));
  await app.segments();
  await name(app, 1).fill("limp");
  for (const button of ["Segments", "Table", "BABEL", "Audacity", "ELAN"] as const) {
    const saved = await app.saveSegments(button);
    await app.drop(file(saved.name, saved.text));
    await expect(app.panel).toContainText(saved.name);
    for (const within of ["0.5", "1.0"]) {
      const row = app.panel.getByRole("row", { name: `± ${within} s` });
      await expect(row.getByRole("cell")).toHaveText(["100", "100", "100"]);
    }
    await app.panel.getByRole("button", { name: "Remove", exact: true }).click();
  }
  await expect(app.alert).toBeHidden();
});

test("compares with segments that are dropped with the clip", async ({ app, page }) => {
  await app.openStartPage();
  const truth = {
    "limp-to-run": [
      { start: 1, end: 380, label: "limp" },
      { start: 381, end: 744, label: "run" },
    ],
  };
  await app.drop(file("truth.json", JSON.stringify(truth)), sample("limp-to-run"));
  await app.waitForClip("limp-to-run.bvh");
  await expect(page.getByRole("tabpanel", { name: "Segment" })).toContainText("truth.json");
  const row = app.panel.getByRole("row", { name: "± 1.0 s" });
  await expect(row.getByRole("cell").nth(1)).toHaveText("100");
  // Reference labels and reference segments can be used together.
  await app.drop(clip("samples/limp-to-run.json"));
  await expect(page.getByRole("tabpanel", { name: "Score" })).toContainText("limp-to-run.json");
  await app.tab("Segment");
  await expect(app.panel).toContainText("truth.json");
});

test("rejects segments of another clip", async ({ app }) => {
  await app.openSample("limp-to-run");
  const saved = await app.saveSegments("Segments");
  await app.drop(sample("bowling"));
  await app.waitForClip("bowling.bvh");
  await app.drop(file(saved.name, saved.text));
  await expect(app.alert).toContainText("744");
  await expect(app.alert).toContainText("316");
});

test("cancels a slow segmentation immediately and restores the previous one", async ({ app }) => {
  await app.openFile(repeated(sample("limp-to-run"), 14));
  const before = await app.segments();
  await name(app, 1).fill("first");
  const tracks = await app.tracks.screenshot();
  await menu(app).selectOption("mvu");
  const cancel = app.page.getByRole("button", { name: "Cancel" });
  await expect(cancel).toBeVisible();
  const bar = app.page.getByRole("progressbar", { name: /^Segmenting/ });
  await expect.poll(async () => Number(await bar.getAttribute("value"))).toBeGreaterThan(0);
  const frames = await cancel.evaluate(async (button) => {
    (button as HTMLButtonElement).click();
    let count = 0;
    for (; document.querySelector(".progress"); count++) await new Promise(requestAnimationFrame);
    return count;
  });
  expect(frames).toBeLessThan(5);
  await expect(menu(app)).toHaveValue("auto");
  // Limping and running alternate, and a name is that of the action.
  const named = before.map((segment, i) => (i % 2 ? segment : { ...segment, name: "first" }));
  expect(await app.segments()).toEqual(named);
  expect(await app.tracks.screenshot()).toEqual(tracks);
  // The new worker has restored names and labels.
  const { segments } = read((await app.saveSegments("Segments")).text);
  await expect(app.panel.getByRole("heading", { name: "Segments" })).toContainText(
    String(segments.length),
  );
  expect(segments[0]?.label).toBe("first");
  expect((await app.result("Left")).plants).toBeGreaterThan(100);
});

test("detects plants with new settings during a segmentation", async ({ app, page }) => {
  await app.openFile(repeated(sample("limp-to-run"), 14));
  const robust = (await app.result("Left")).plants;
  await app.tab("Segment");
  await menu(app).selectOption("mvu");
  await expect(page.getByRole("button", { name: "Cancel" })).toBeVisible();
  await app.tab("Detect");
  await page.getByRole("combobox", { name: "Method" }).selectOption("speed");
  await page.getByRole("button", { name: "Cancel" }).click();
  await expect.poll(async () => (await app.result("Left")).plants).not.toBe(robust);
  await app.tab("Segment");
  expect((await app.segments()).length).toBeGreaterThan(1);
});

test("segments again when the rate changes", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.tab("Clip");
  const rate = page.getByRole("spinbutton", { name: "Rate" });
  await rate.fill("48");
  await rate.press("Enter");
  await expect(app.head).toContainText("48 Hz");
  await expect
    .poll(async () => {
      const last = (await app.segments()).at(-1);
      return Math.round(10 * ((last?.start ?? 0) + (last?.length ?? 0)));
    })
    .toBe(155);
});

test("reports that a clip is too short to segment", async ({ app }) => {
  await app.openFile(good("plain"));
  expect(await app.segments()).toHaveLength(1);
  await expect(app.panel).toContainText("shorter than");
});

test("reports that a skeleton cannot be segmented", async ({ app, page }) => {
  const rows = Array.from({ length: 90 }, (_, i) => `${i} 0 0 0 0 ${i}`).join("\n");
  const body = `HIERARCHY
ROOT Thing
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  End Site
  {
    OFFSET 0 10 0
  }
}
MOTION
Frames: 90
Frame Time: 0.0333333
${rows}
`;
  await app.openFile(file("thing.bvh", body));
  await app.tab("Segment");
  await expect(app.panel).toContainText(/Only 0 of the \d+ joints/);
  await expect(app.panel.getByRole("button", { name: "Save", exact: true })).toBeHidden();
  await page.keyboard.press("End");
  expect(await app.frame()).toBe(89);
  await page.keyboard.press("s");
  await page.keyboard.press("[");
  expect(await app.frame()).toBe(0);
});
