/** What is done by keys elsewhere is done by buttons on touch screens, upright and in landscape. */

import { expect, test } from "./app";
import { clip, sample } from "./clips";
import { readLabels } from "./labels";
import { editBar, overlap, smallTargets, tapPlant, tapSecondPlant } from "./touch-targets";
import { encodeVideo } from "./videos";
import { onPhones } from "./viewports";

onPhones((size) => {
  test("moves both ends of a plant by single frames, and undoes it", async ({ app }) => {
    const plant = await tapPlant(app);
    const bar = editBar(app);
    const values = bar.locator(".edit-value");
    await expect(values).toHaveText([`First${plant.start}`, `Last${plant.end - 1}`]);
    for (let i = 0; i < 3; i++) await bar.getByRole("button", { name: "Last frame earlier" }).tap();
    await expect(values).toHaveText([`First${plant.start}`, `Last${plant.end - 4}`]);
    expect(await app.frame()).toBe(plant.end - 4);
    await bar.getByRole("button", { name: "First frame later" }).tap();
    await expect(values).toHaveText([`First${plant.start + 1}`, `Last${plant.end - 4}`]);
    expect(await app.frame()).toBe(plant.start + 1);
    for (let i = 0; i < 4; i++) await bar.getByRole("button", { name: "Undo" }).tap();
    await expect(values).toHaveText([`First${plant.start}`, `Last${plant.end - 1}`]);
    await expect(bar.getByRole("button", { name: "Undo" })).toBeDisabled();
    await bar.getByRole("button", { name: "Delete" }).tap();
    await expect(values).toHaveCount(0);
    const left = async () => readLabels(await app.save("Labels")).left.contact?.length;
    expect(await left()).toBe(2);
    const lower = app.page.getByRole("button", { name: "Collapse panel" });
    if (await lower.isVisible()) await lower.tap();
    await bar.getByRole("button", { name: "Undo" }).tap();
    await expect(bar.getByRole("button", { name: "Redo" })).toBeEnabled();
    expect(await left()).toBe(3);
  });

  test("moves edges by single frames in the Labels tab", async ({ app }) => {
    const plant = await tapPlant(app);
    await app.tab("Labels");
    const last = app.panel.getByRole("spinbutton", { name: "Last frame" });
    await app.panel.getByRole("button", { name: "Last frame later" }).tap();
    await expect(last).toHaveValue(String(plant.end));
    await app.panel.getByRole("button", { name: "Last frame earlier" }).tap();
    await expect(last).toHaveValue(String(plant.end - 1));
    expect((await last.boundingBox())?.width).toBeGreaterThanOrEqual(44);
  });

  test("moves a cut by single frames and removes it", async ({ app, page }) => {
    await app.openSample("limp-to-run");
    await app.tab("Segment");
    await page.keyboard.press("]");
    const cut = await app.frame();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("x");
    const field = app.panel.getByRole("spinbutton", { name: "Cut at frame" });
    await expect(field).toHaveValue(String(cut + 2));
    await app.panel.getByRole("button", { name: "Cut later" }).tap();
    await expect(field).toHaveValue(String(cut + 3));
    const lower = page.getByRole("button", { name: "Collapse panel" });
    if (await lower.isVisible()) await lower.tap();
    const bar = editBar(app);
    await bar.getByRole("button", { name: "Cut earlier" }).tap();
    await expect(bar.locator(".edit-value")).toHaveText([`Cut${cut + 2}`]);
    await bar.getByRole("button", { name: "Delete" }).tap();
    await expect(bar.locator(".edit-value")).toHaveCount(0);
  });

  test("the buttons for edits fit into the view", async ({ app }) => {
    await tapPlant(app);
    const bar = editBar(app);
    await expect(bar).toBeInViewport({ ratio: 1 });
    const expectNoOverlap = async () => {
      for (const other of [
        app.view.getByRole("group", { name: "Camera" }),
        app.view.getByRole("button", { name: "Follow" }),
        app.view.locator(".pill.left"),
        app.view.locator(".pill.right"),
      ])
        expect(await overlap(bar, other)).toBe(0);
    };
    await expectNoOverlap();
    await bar.getByRole("button", { name: "Last frame later" }).tap();
    const undo = bar.getByRole("button", { name: "Undo" });
    await expect(undo).toBeEnabled();
    const place = await undo.boundingBox();
    for (const button of await bar.getByRole("button").all()) {
      const box = await button.boundingBox();
      if (box) expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(44);
    }
    // In landscape, they replace those of the camera.
    const camera = app.view.getByRole("group", { name: "Camera" });
    await expect(camera).toBeVisible({ visible: size === "phone" });
    await app.page.keyboard.press("Escape");
    await expect(camera).toBeVisible();
    await expectNoOverlap();
    // Undo stays at its place.
    expect(await undo.boundingBox()).toEqual(place);
  });

  test("the buttons for edits do not cover the character next to a video", async ({ app }) => {
    await app.openSample("curved-walk");
    await app.drop(await encodeVideo(app.page, "walk.webm", 24, 24));
    await expect(app.page.locator(".video-picture canvas")).toBeVisible();
    await tapSecondPlant(app);
    const bar = editBar(app);
    const video = app.page.getByRole("region", { name: "Video" });
    const view = app.view.locator(".stage");
    const [box, stage] = [await bar.boundingBox(), await view.boundingBox()];
    if (!box || !stage) throw new Error("There is no view.");
    // The character is in the middle of the view.
    const isAside = box.x + box.width < stage.x + stage.width / 2 - 10;
    expect(isAside || (await overlap(bar, view)) === 0).toBe(true);
    const others = [video, app.tracks, app.timeline.getByRole("button", { name: "Play" })];
    for (const other of others) expect(await overlap(bar, other)).toBe(0);
    for (const part of [bar, app.tracks, ...others])
      await expect(part).toBeInViewport({ ratio: 1 });
    await bar.getByRole("button", { name: "Last frame earlier" }).tap();
    await expect(bar.getByRole("button", { name: "Undo" })).toBeEnabled();
    expect(await bar.boundingBox()).toEqual(box);
  });

  test("steps through the frames without the panel", async ({ app }) => {
    await app.openSample("curved-walk");
    const steps = app.view.getByRole("group", { name: "Frame", exact: true });
    const ahead = steps.getByRole("button", { name: "Next frame" });
    await ahead.tap();
    await ahead.tap();
    await expect.poll(() => app.frame()).toBe(2);
    await steps.getByRole("button", { name: "Previous frame" }).tap();
    await expect.poll(() => app.frame()).toBe(1);
    await tapSecondPlant(app);
    await expect(steps).toBeInViewport({ ratio: 1 });
    for (const other of [
      editBar(app),
      app.view.getByRole("group", { name: "Camera" }),
      app.view.getByRole("button", { name: "Follow" }),
      app.view.locator(".pill.left"),
      app.view.locator(".pill.right"),
      app.page.locator(".message"),
    ])
      expect(await overlap(steps, other)).toBe(0);
    await app.tab("Labels");
    await expect(steps).toBeInViewport({ ratio: 1 });
    // The raised sheet has the buttons for edits, and leaves no space for others.
    await expect(editBar(app)).toBeVisible({ visible: size !== "phone" });
  });

  test("has touch targets of at least 44 pixels", async ({ app, page }) => {
    await tapPlant(app);
    for (const tab of ["Detect", "Evidence", "Segment", "Labels", "Clip"] as const) {
      await app.tab(tab);
      expect(await smallTargets(app), tab).toEqual([]);
    }
    await app.timeline.getByRole("button", { name: "Tracks" }).tap();
    expect(await smallTargets(app)).toEqual([]);
    await page.keyboard.press("Escape");
    await app.openShareDialog();
    expect(await smallTargets(app)).toEqual([]);
  });

  test("tabs and buttons of differences are wide enough", async ({ app, page }) => {
    await app.openSample("curved-walk");
    await app.drop(clip("samples/curved-walk.json"));
    await expect(page.getByRole("tabpanel", { name: "Score" })).toBeVisible();
    const tabs = await page.getByRole("tab").evaluateAll((elements) =>
      elements.map((element) => {
        const text = document.createRange();
        text.selectNodeContents(element);
        const { left, right } = text.getBoundingClientRect();
        return { left, right, width: element.getBoundingClientRect().width };
      }),
    );
    expect(tabs).toHaveLength(6);
    expect(Math.min(...tabs.map(({ width }) => width))).toBeGreaterThanOrEqual(36);
    const gaps = tabs.slice(1).map(({ left }, i) => left - (tabs[i]?.right ?? 0));
    expect(Math.min(...gaps)).toBeGreaterThanOrEqual(4);
    for (const name of ["Previous difference", "Next difference"]) {
      const button = app.panel.getByRole("button", { name });
      expect((await button.boundingBox())?.width).toBeGreaterThanOrEqual(44);
    }
  });

  test("shows clips side by side", async ({ app, page }) => {
    await app.openSample("curved-walk");
    await page.keyboard.press("e");
    await page.keyboard.press("q");
    await app.drop(sample("bowling"), sample("frog-jumps"));
    const button = page.getByRole("button", { name: "bowling.bvh side by side" });
    await expect(button).toHaveCSS("opacity", "1");
    await button.tap();
    await expect(button).toHaveAttribute("aria-pressed", "true");
    await page.getByRole("button", { name: "Back to curved-walk.bvh" }).tap();
    const shown = page.getByRole("list", { name: "Comparison clips" });
    await expect(shown).toBeInViewport({ ratio: 1 });
    const others = [editBar(app), app.view.locator(".pill.left"), app.view.locator(".pill.right")];
    for (const other of others) expect(await overlap(shown, other)).toBe(0);
    // Files are opened, not dropped.
    await app.tab("Segment");
    await expect(app.panel.getByText("a segment file")).toBeVisible();
    await expect(app.panel.getByText("or drop")).toBeHidden();
  });

  test("leaves timeline and transport in sight while the panel is open", async ({ app }) => {
    await app.openSample("frog-jumps");
    for (const tab of ["Labels", "Segment", "Clip"] as const) {
      await app.tab(tab);
      for (const part of [
        app.tracks.locator("xpath=.."),
        app.timeline.getByRole("button", { name: "Play" }),
        app.timeline.getByRole("button", { name: "Fit" }),
        app.head.getByRole("button", { name: "Open", exact: true }),
        app.head.getByRole("button", { name: "Keyboard shortcuts" }),
      ])
        await expect(part).toBeInViewport({ ratio: 1 });
      expect((await app.stage.boundingBox())?.height).toBeGreaterThanOrEqual(140);
    }
  });
});
