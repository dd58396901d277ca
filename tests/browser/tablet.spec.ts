/** Tablets: larger than a phone, and used by touch. */

import type { Locator } from "@playwright/test";
import { expect, test } from "./app";
import { clip, sample } from "./clips";
import { readLabels } from "./labels";
import { editBar, overlap, smallTargets, tapPlant } from "./touch-targets";
import { encodeVideo } from "./videos";
import { onTablets } from "./viewports";

const tabs = ["Detect", "Evidence", "Segment", "Labels", "Clip"] as const;

/** Fails if two of the elements overlap. */
async function expectDisjoint(elements: readonly Locator[]) {
  for (const [i, element] of elements.entries())
    for (const other of elements.slice(i + 1))
      expect(await overlap(element, other), `${element} and ${other}`).toBe(0);
}

onTablets(() => {
  test("has touch targets of at least 44 pixels", async ({ app }) => {
    await tapPlant(app);
    for (const tab of tabs) {
      await app.tab(tab);
      expect(await smallTargets(app), tab).toEqual([]);
    }
    await app.openShareDialog();
    expect(await smallTargets(app)).toEqual([]);
  });

  test("has bars of heel and toe that are large enough for touch", async ({ app, page }) => {
    await app.openSample("frog-jumps");
    const toe = readLabels(await app.save("Labels")).left.toe ?? [];
    const long = toe.toSorted((a, b) => b.end - b.start - (a.end - a.start))[0];
    const box = await app.tracks.boundingBox();
    if (!long || !box) throw new Error("The toe is never planted.");
    const first = await app.pressRuler(0.5);
    const perFrame = (0.25 * box.width) / ((await app.pressRuler(0.75)) - first);
    const x = box.x + 0.5 * box.width + ((long.start + long.end) / 2 - first) * perFrame;
    const title = app.panel.getByText("Left toe");
    await app.tab("Labels");
    let hit = 0;
    for (let y = 40; y < 150; y += 2) {
      // A tap elsewhere in between prevents double taps.
      await page.touchscreen.tap(box.x + 0.5 * box.width, box.y + 12);
      await page.touchscreen.tap(x, box.y + y);
      if (await title.isVisible()) hit += 2;
    }
    expect(hit).toBeGreaterThanOrEqual(18);
  });

  test("the controls in the view do not overlap", async ({ app, page }) => {
    await tapPlant(app);
    const controls = [
      editBar(app),
      app.view.getByRole("group", { name: "Camera" }),
      app.view.locator(".pill.left"),
      app.view.locator(".pill.right"),
      app.view.locator(".grid-size"),
      app.view.getByRole("list", { name: "Comparison clips" }),
    ];
    const others = [
      app.view.getByRole("group", { name: "Frame", exact: true }),
      app.page.locator(".message"),
    ];
    const expectMiddleFree = async () => {
      await editBar(app).getByRole("button", { name: "Last frame later" }).tap();
      await expect(app.page.locator(".message")).toBeVisible();
      await expectDisjoint([...controls.slice(0, 4), ...others]);
      // The character is in the middle of the view.
      const { x = 0, width = 0 } = (await app.stage.boundingBox()) ?? {};
      const bar = await editBar(app).boundingBox();
      const isAside = (bar?.x ?? 0) + (bar?.width ?? 0) < x + width / 2 - 10;
      expect(isAside || (await overlap(editBar(app), app.stage)) === 0).toBe(true);
    };
    await expectDisjoint(controls);
    await expectMiddleFree();
    const clips = ["bowling", "frog-jumps", "ballet", "skipping", "straight-jog"];
    await app.drop(...clips.map(sample));
    await expect(page.getByText(/^All processed/)).toBeVisible();
    // The names stay in sight while the table is scrolled.
    const name = page.getByRole("button", { name: "frog-jumps.bvh", exact: true });
    const place = await name.boundingBox();
    await page.locator(".batch-scroll").evaluate((table) => table.scrollTo(table.scrollWidth, 0));
    await expect(page.getByRole("columnheader", { name: "Processing" })).toBeInViewport({
      ratio: 1,
    });
    expect(await name.boundingBox()).toEqual(place);
    for (const name of clips)
      await page.getByRole("button", { name: `${name}.bvh side by side` }).tap();
    await page.getByRole("button", { name: "Back to curved-walk.bvh" }).tap();
    await expect(controls.at(-1) as Locator).toBeVisible();
    await expectDisjoint(controls);
    // The overview stays in sight.
    const container = app.tracks.locator("xpath=..");
    expect((await app.tracks.boundingBox())?.height).toBeLessThanOrEqual(
      (await container.boundingBox())?.height ?? 0,
    );
    await app.drop(await encodeVideo(page, "walk.webm", 12, 24));
    const video = page.getByRole("region", { name: "Video" });
    await expect(video).toBeVisible();
    await expectDisjoint([...controls.slice(0, 4), video]);
    await expectMiddleFree();
  });

  test("the panel cuts no text, and separates its columns and buttons", async ({ app }) => {
    await app.openSample("limp-to-run");
    await app.drop(clip("samples/limp-to-run.json"));
    await app.playhead.focus();
    await app.page.keyboard.press("e");
    for (const tab of [...tabs, "Score"] as const) {
      await app.tab(tab);
      await expect(app.panel.locator("[aria-busy=true]")).toHaveCount(0);
      if (tab === "Clip") await expect(app.panel.getByText(/strides, mean/)).toBeVisible();
      await expect.poll(() => app.panel.evaluate(layoutFaults), tab).toEqual([]);
    }
  });
});

/** Returns the texts that are cut or that leave the panel, and neighbours that touch each other. */
function layoutFaults(panel: Element): string[] {
  const faults: string[] = [];
  const { right, left } = panel.getBoundingClientRect();
  const { paddingLeft, paddingRight } = getComputedStyle(panel);
  const inner = [left + Number.parseFloat(paddingLeft), right - Number.parseFloat(paddingRight)];
  const [from = 0, to = 0] = inner;
  const visible = [...panel.querySelectorAll("button, select, table, .list-columns > span")].filter(
    (element) => element.checkVisibility() && !element.closest(".visually-hidden"),
  );
  for (const element of visible) {
    const box = element.getBoundingClientRect();
    const name = element.textContent?.slice(0, 40) ?? "";
    // Buttons of single icons extend into the padding, so that their icons are aligned.
    const reach = element.matches(".icon-only") ? 10 : 0.5;
    if (box.left < from - reach || box.right > to + reach) faults.push(`outside: ${name}`);
    // Names of joints have any length.
    const isJoint = element.closest(".form-rows") !== null;
    if (element instanceof HTMLSelectElement && element.selectedOptions[0] && !isJoint) {
      const style = getComputedStyle(element);
      const ctx = document.createElement("canvas").getContext("2d");
      if (!ctx) continue;
      ctx.font = style.font;
      const text = ctx.measureText(element.selectedOptions[0].text).width;
      const space =
        box.width - Number.parseFloat(style.paddingLeft) - Number.parseFloat(style.paddingRight);
      if (text > space) faults.push(`cut: ${element.selectedOptions[0].text}`);
    }
    const next = element.nextElementSibling;
    if (!next?.matches(".button, .list-columns > span") || !next.checkVisibility()) continue;
    const textBox = (item: Element) => {
      if (item.matches("button")) return item.getBoundingClientRect();
      const range = document.createRange();
      range.selectNodeContents(item);
      return range.getBoundingClientRect();
    };
    const [a, b] = [textBox(element), textBox(next)];
    const isSameLine = Math.min(a.bottom, b.bottom) > Math.max(a.top, b.top);
    if (isSameLine && b.left - a.right < 2) faults.push(`touching: ${name}, ${next.textContent}`);
  }
  return faults;
}
