/** Frequent tasks in few actions. */

import { type App, expect, test } from "./app";
import { readLabels } from "./labels";
import { atEachSize } from "./viewports";

const labelsOf = async (app: App) => readLabels(await app.save("Labels"));

/** Returns the position of a frame on the contact track of a foot, which the first press finds. */
async function pointOn(app: App, side: "left" | "right", frame: number) {
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const isNarrow = box.width <= 560;
  const labelWidth = isNarrow ? 100 : 118;
  const laneWidth = box.width - labelWidth - 14;
  const frames = (await app.lastFrame()) + 1;
  const x = box.x + labelWidth + ((frame + 0.5) / frames) * laneWidth;
  return { x, y: box.y + (side === "left" ? 46 : await rightTrack(app)) };
}

/** Returns the height of the right contact track below the top of the timeline. */
async function rightTrack(app: App): Promise<number> {
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const readout = app.timeline.locator(".pointed-frame");
  // The first lane after that of the left foot whose plants have numbers.
  let isLeft = true;
  for (let y = 46; y < box.height; y += 3) {
    const numbers = new Set<boolean>();
    for (const position of [0.4, 0.5, 0.6, 0.7, 0.8, 0.9]) {
      await app.page.mouse.move(box.x + position * box.width, box.y + y);
      numbers.add(/plant \d/.test(await readout.innerText()));
    }
    if (isLeft && !numbers.has(true)) isLeft = false;
    else if (!isLeft && numbers.has(true)) return y + 6;
  }
  throw new Error("There is no right contact track.");
}

atEachSize((size) => {
  test("moves a foot off by three frames with three keys", async ({ app, page }) => {
    await app.openSample("curved-walk");
    const before = await labelsOf(app);
    const [plant] = before.left.contact ?? [];
    if (!plant) throw new Error("There is no plant.");
    for (let i = 0; (await app.frame()) < plant.end - 1 && i < 300; i++)
      await page.keyboard.press("ArrowRight");
    for (let i = 0; i < 3; i++) await page.keyboard.press("q");
    await expect.poll(async () => (await labelsOf(app)).left.contact?.[0]?.end).toBe(plant.end - 3);
    expect(await app.frame()).toBe(plant.end - 4);
    await page.keyboard.press("Shift+w");
    await expect.poll(async () => (await labelsOf(app)).left.contact?.[0]?.end).toBe(plant.end + 2);
  });

  test("adds a plant on either track by a click and a key", async ({ app, page }) => {
    await app.openSample("curved-walk");
    for (const side of ["left", "right"] as const) {
      const before = await labelsOf(app);
      const planted = before[side].contact ?? [];
      const gap = planted[0];
      const next = planted[1];
      if (!gap || !next) throw new Error("There are no two plants.");
      const middle = Math.round((gap.end + next.start) / 2);
      const { x, y } = await pointOn(app, side, middle);
      await page.mouse.click(x, y);
      await page.keyboard.press("a");
      const message = `${side === "left" ? "Left" : "Right"} contact added`;
      await expect(page.locator(".message")).toContainText(message);
      await expect
        .poll(async () => (await labelsOf(app))[side].contact?.length)
        .toBe(planted.length + 1);
      const other = side === "left" ? "right" : "left";
      expect((await labelsOf(app))[other]).toEqual(before[other]);
      await page.keyboard.press("Delete");
      await expect
        .poll(async () => (await labelsOf(app))[side].contact?.length)
        .toBe(planted.length);
    }
  });

  test("steps through low confidence, loops a range, and reads values", async ({ app, page }) => {
    await app.openSample("curved-walk");
    await test.step("steps through the plants of low confidence", async () => {
      await app.tab("Labels");
      const uncertain = app.panel.getByRole("button", { name: /review$/ });
      await expect(uncertain).toHaveCount(2);
      for (const i of [0, 1, 0]) {
        await page.keyboard.press("u");
        await expect(uncertain.nth(i)).toHaveAttribute("aria-pressed", "true");
      }
      await page.keyboard.press("Shift+u");
      await expect(uncertain.nth(1)).toHaveAttribute("aria-pressed", "true");
    });
    await test.step("loops a free range by a drag and by keys", async () => {
      const from = await app.ruler(0.4);
      const to = await app.ruler(0.6);
      const first = await app.pressRuler(0.4);
      // The handle of the playhead would be dragged.
      await page.keyboard.press("Home");
      await page.keyboard.down("Shift");
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      await page.mouse.move(to.x, to.y, { steps: 4 });
      await page.mouse.up();
      await page.keyboard.up("Shift");
      const loop = app.timeline.getByRole("button", { name: /^Loop/ });
      await expect(loop).toHaveText(new RegExp(`^Loop ${first}–\\d+$`));
      await page.keyboard.press("Home");
      await page.keyboard.press("ArrowRight");
      await page.keyboard.press("Shift+i");
      await page.keyboard.press("ArrowRight");
      await page.keyboard.press("ArrowRight");
      await page.keyboard.press("Shift+o");
      await expect(loop).toHaveText("Loop 1–3");
      await page.keyboard.press("Shift+l");
      await expect(loop).toHaveText("Loop off");
    });
    await test.step("reads values under the pointer and of a dragged edge", async () => {
      const readout = app.timeline.locator(".pointed-frame");
      const [plant] = (await labelsOf(app)).left.contact ?? [];
      if (!plant) throw new Error("There is no plant.");
      const inside = await pointOn(app, "left", 20);
      await page.mouse.move(inside.x, inside.y);
      await expect(readout).toContainText(/20 0\.167 s plant 1, confidence \d+ %/);
      if (size === "desktop") {
        // Smaller timelines have no space for curves.
        const box = await app.tracks.boundingBox();
        await page.mouse.move(inside.x, (box?.y ?? 0) + 165);
        await expect(readout).toContainText(/20 .*L \d+\.\d cm\s+R \d+\.\d cm/);
      }
      const edge = await pointOn(app, "left", plant.end - 0.5);
      const target = await pointOn(app, "left", plant.end + 5.5);
      await page.mouse.move(edge.x - 1, edge.y);
      await page.mouse.down();
      await page.mouse.move(target.x, target.y, { steps: 4 });
      await expect(readout).toContainText(/last frame, \+\d/);
      await page.mouse.up();
      await expect
        .poll(async () => (await labelsOf(app)).left.contact?.[0]?.end)
        .not.toBe(plant.end);
    });
  });

  test("reports on the page what an edit did, or why it did nothing", async ({ app, page }) => {
    await app.openSample("curved-walk");
    const message = page.locator(".message");
    await page.keyboard.press("e");
    await page.keyboard.press("a");
    await expect(message).toHaveText("The left foot is already planted at the playhead");
    const last = app.panel.getByRole("spinbutton", { name: "Last frame" });
    await app.tab("Labels");
    await last.fill("300");
    await page.keyboard.press("Enter");
    await expect(message).toHaveText("Frames 0 to 244, joined with 2 plants");
    await page.keyboard.press("Control+z");
    await expect(message).toHaveText("Undone: Frames 0 to 244, joined with 2 plants");
    await expect(message).toBeHidden();
  });

  test("judges a clip: counts, largest slide, foot skate of one plant", async ({ app, page }) => {
    await app.openSample("limp-to-run");
    await test.step("all counts of plants agree", async () => {
      const count = (await app.result("Left")).plants + (await app.result("Right")).plants;
      expect(count).toBeGreaterThan(30);
      const table = app.timeline.getByRole("table", { name: `${count} plants` });
      await expect(table.getByRole("row")).toHaveCount(count + 1);
      await app.tab("Labels");
      await expect(app.panel.getByRole("heading", { name: `Plants ${count}` })).toBeVisible();
      const { left, right } = await labelsOf(app);
      expect((left.contact?.length ?? 0) + (right.contact?.length ?? 0)).toBe(count);
    });
    await test.step("goes to the frame with the largest slide", async () => {
      await app.tab("Clip");
      const slide = app.panel.getByRole("button", { name: /cm$/ });
      const title = (await slide.getAttribute("title")) ?? "";
      const frame = Number(title.match(/\d+/)?.[0]);
      await slide.click();
      expect(await app.frame()).toBe(frame);
      const plants = await labelsOf(app);
      const starts = [...(plants.left.contact ?? []), ...(plants.right.contact ?? [])];
      expect(starts.some(({ start, end }) => start < frame && frame < end)).toBe(true);
    });
    await test.step("corrects the foot skate of one plant", async () => {
      await page.keyboard.press("e");
      await app.tab("Clip");
      await app.panel.getByRole("button", { name: "Only selected plant" }).click();
      await expect(app.panel.getByText("Only the selected plant is corrected.")).toBeVisible();
      await app.panel.getByRole("button", { name: "Discard" }).click();
      await expect(app.panel.getByRole("button", { name: "Fix foot skate" })).toBeVisible();
    });
  });
});

test("a message disappears while others are announced", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await page.keyboard.press("e");
  await page.keyboard.press("a");
  const message = page.locator(".message");
  await expect(message).toBeVisible();
  await expect(async () => {
    // Announces the next plant at the playhead.
    await page.keyboard.press("e");
    await expect(message).toBeHidden({ timeout: 100 });
  }).toPass();
});

test("marks the selected plant in the list", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.tab("Labels");
  await page.keyboard.press("e");
  await page.keyboard.press("End");
  const selected = app.panel.getByRole("button", { pressed: true });
  await expect(selected).not.toHaveAttribute("aria-current");
  await expect(selected).not.toHaveCSS("background-color", "rgba(0, 0, 0, 0)");
});
