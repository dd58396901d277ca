/** A video next to the clip: its picture i belongs to frame i of the clip. */

import AxeBuilder from "@axe-core/playwright";
import { type App, expect, test } from "./app";
import { file, sample } from "./clips";
import { encodeVideo, type Shown, shownDuring, shownNow } from "./videos";
import { viewports } from "./viewports";

/** Frame rate of the clip `limp-to-run` and of the videos, in Hz. */
const rate = 24;

const pane = (app: App) => app.page.getByRole("region", { name: "Video" });

/** Opens a clip of 744 frames with a video of `pictures` pictures. */
async function openWithVideo(app: App, pictures = 744) {
  await app.openSample("limp-to-run");
  const video = await encodeVideo(app.page, "walk.webm", pictures, rate);
  await app.drop(video);
  await expect(pane(app)).toBeVisible();
  await expect.poll(() => shownNow(app.page)).toEqual({ frame: 0, picture: 0 });
  return video;
}

const difference = ({ frame, picture }: Shown) => picture - frame;

/** Expects that the picture of the frame under the playhead is on show. */
const expectPicture = (app: App, frame: number, picture = frame) =>
  expect.poll(() => shownNow(app.page)).toEqual({ frame, picture });

test("shows the picture of the frame while paused and scrubbing", async ({ app, page }) => {
  await openWithVideo(app);
  for (const [key, frame] of [
    ["ArrowRight", 1],
    [".", 2],
    [",", 1],
    ["End", 743],
    ["ArrowLeft", 742],
    ["Home", 0],
  ] as const) {
    await page.keyboard.press(key);
    await expectPicture(app, frame);
  }
  for (const position of [0.3, 0.72, 0.5]) {
    await expectPicture(app, await app.pressRuler(position));
  }
  // Scrubbing: the picture follows, and is that of the last frame in the end.
  const from = await app.ruler(0.2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 1; i <= 30; i++) await page.mouse.move(from.x + 20 * i, from.y);
  await expectPicture(app, await app.frame());
  await page.mouse.up();
  expect(await app.frame()).toBeGreaterThan(300);
});

for (const speed of ["1", "0.25", "4"]) {
  test(`stays within a frame during playback at ${speed}×`, async ({ app, page }) => {
    await openWithVideo(app);
    await app.timeline.getByRole("combobox", { name: "Speed" }).selectOption(speed);
    await page.keyboard.press("Space");
    const shown = await shownDuring(page, { until: speed === "0.25" ? 20 : 150 });
    expect(shown.length).toBeGreaterThan(10);
    const differences = shown.map(difference);
    expect(Math.min(...differences)).toBeGreaterThanOrEqual(-1);
    expect(Math.max(...differences)).toBeLessThanOrEqual(1);
    await page.keyboard.press("Space");
    await expectPicture(app, await app.frame());
  });
}

test("stays within a frame when playback jumps, loops and changes its speed", async ({
  app,
  page,
}) => {
  await openWithVideo(app);
  await page.keyboard.press("Space");
  const all = await shownDuring(page, { until: 24 });
  // A press on the ruler pauses.
  await expectPicture(app, await app.pressRuler(0.6));
  await page.keyboard.press("Space");
  all.push(...(await shownDuring(page, { until: 470 })));
  await page.keyboard.press(">");
  all.push(...(await shownDuring(page, { until: 500 })));
  expect(all.filter((shown) => Math.abs(difference(shown)) > 1)).toEqual([]);
  await app.pressRuler(0.97);
  await page.keyboard.press("Space");
  // The clip loops.
  await expect.poll(() => app.frame()).toBeLessThan(100);
  await expect.poll(async () => Math.abs(difference(await shownNow(page)))).toBeLessThanOrEqual(1);
  const after = await shownDuring(page, { until: 150 });
  expect(after.filter((shown) => Math.abs(difference(shown)) > 1)).toEqual([]);
  await page.keyboard.press("Space");
  await expectPicture(app, await app.frame());
});

test("plays beyond the end of a shorter video", async ({ app, page }) => {
  await openWithVideo(app, 48);
  await app.pressRuler(0.15);
  await page.keyboard.press("Home");
  await page.keyboard.press("Space");
  await expect.poll(() => app.frame()).toBeGreaterThan(70);
  await page.keyboard.press("Space");
  await expectPicture(app, await app.frame(), 47);
  await page.keyboard.press("Home");
  await expectPicture(app, 0);
});

test("is aligned by numbers, keys and drag", async ({ app, page }) => {
  await openWithVideo(app, 240);
  await pane(app).getByRole("button", { name: "Align" }).click();
  const seconds = pane(app).getByRole("spinbutton", { name: "Offset, s" });
  const frames = pane(app).getByRole("spinbutton", { name: "Offset, frames" });
  await app.page.keyboard.press("Escape");
  await frames.fill("-30");
  await frames.press("Enter");
  await expect(seconds).toHaveValue("-1.25");
  await expectPicture(app, 0, 30);
  await seconds.fill("-0.5");
  await seconds.press("Enter");
  await expectPicture(app, 0, 12);
  const bar = app.timeline.getByRole("slider", { name: "Beginning of the video" });
  await bar.focus();
  await page.keyboard.press("ArrowLeft");
  await expectPicture(app, 0, 13);
  await page.keyboard.press("Shift+ArrowLeft");
  await expectPicture(app, 0, 23);
  await page.keyboard.press("Shift+ArrowRight");
  await expectPicture(app, 0, 13);
  const box = await bar.boundingBox();
  if (!box) throw new Error("There is no bar.");
  await page.mouse.move(box.x + box.width - 8, box.y + 8);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width - 68, box.y + 8, { steps: 4 });
  await page.mouse.up();
  await expect.poll(async () => (await shownNow(page)).picture).toBeGreaterThan(30);
  // A video in slow motion.
  await frames.fill("0");
  await frames.press("Enter");
  await pane(app).getByRole("spinbutton", { name: "Rate" }).fill("4");
  await pane(app).getByRole("spinbutton", { name: "Rate" }).press("Enter");
  await app.playhead.focus();
  await page.keyboard.press("ArrowRight");
  await expectPicture(app, 1, 4);
});

test("remembers the alignment, and asks for the file again after a reload", async ({
  app,
  page,
}) => {
  const video = await openWithVideo(app, 120);
  const bar = app.timeline.getByRole("slider", { name: "Beginning of the video" });
  await bar.focus();
  await page.keyboard.press("Shift+ArrowLeft");
  await expectPicture(app, 0, 10);
  await page.reload();
  await app.waitForClip("limp-to-run.bvh");
  await expect(pane(app)).toContainText("walk.webm");
  await expect(pane(app)).toContainText("choose the file again");
  const chosen = page.waitForEvent("filechooser");
  await pane(app).getByRole("button", { name: "Choose video" }).click();
  await (await chosen).setFiles(video);
  await expectPicture(app, 0, 10);
  // The alignment is forgotten with the video.
  await pane(app).getByRole("button", { name: "Remove the video" }).click();
  await expect(pane(app)).toBeHidden();
  await page.reload();
  await app.waitForClip("limp-to-run.bvh");
  await expect(pane(app)).toBeHidden();
});

test("is muted at first, and neither in links nor in shared pages", async ({ app, page }) => {
  await openWithVideo(app, 48);
  const isMuted = () => page.evaluate(() => document.querySelector("video")?.muted);
  expect(await isMuted()).toBe(true);
  const sound = pane(app).getByRole("button", { name: "Sound" });
  await expect(sound).toHaveAttribute("aria-pressed", "false");
  await sound.click();
  await expect(sound).toHaveAttribute("aria-pressed", "true");
  expect(await isMuted()).toBe(false);
  expect(await app.link()).not.toContain("walk");
  const saved = await app.savePage();
  expect(saved.text).not.toContain("walk.webm");
});

test("reports a video that cannot be decoded, and the clip plays on", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await app.drop(file("broken.mp4", "\0\0\0\x18ftypisom and no more"));
  await expect(pane(app).getByRole("alert")).toContainText("broken.mp4 cannot be shown");
  await page.keyboard.press("Space");
  await expect.poll(() => app.frame()).toBeGreaterThan(5);
  await page.keyboard.press("Space");
  await pane(app).getByRole("button", { name: "Remove the video" }).click();
  await expect(pane(app)).toBeHidden();
});

test("opens with a clip of the same drop, by key, and not without a clip", async ({
  app,
  page,
}) => {
  // Registered early, because the browser has to be told before the key is pressed.
  const chosen = page.waitForEvent("filechooser");
  await app.openStartPage();
  const video = await encodeVideo(page, "walk.webm", 24, rate);
  await app.drop(video);
  await expect(app.toast).toContainText("Open a clip with motion first");
  await app.drop(sample("bowling"), video);
  await app.waitForClip("bowling.bvh");
  await expect(pane(app)).toBeVisible();
  await page.keyboard.press("v");
  await (await chosen).setFiles({ ...video, name: "other.webm" });
  await expect(pane(app).getByText("other.webm")).toBeVisible();
});

test("is resized by keys", async ({ app, page }) => {
  await openWithVideo(app, 24);
  const width = async () => (await pane(app).boundingBox())?.width ?? 0;
  const before = await width();
  await page.getByRole("separator", { name: "Width of the video" }).focus();
  await page.keyboard.press("ArrowLeft");
  await expect.poll(width).toBeCloseTo(before + 24, -1);
});

for (const name of ["phone", "landscape phone", "small window"] as const) {
  for (const scheme of ["dark", "light"] as const) {
    test.describe(`on a page of the size ${name}, ${scheme}`, () => {
      test.use({ viewport: viewports[name], colorScheme: scheme });

      test("view and video are next to each other and accessible", async ({ app, page }) => {
        await openWithVideo(app, 24);
        await expect(page.locator("video")).toBeInViewport({ ratio: 1 });
        expect((await app.stage.boundingBox())?.width).toBeGreaterThan(150);
        const overflow = await page.evaluate(
          () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
        );
        expect(overflow).toBe(0);
        const { violations } = await new AxeBuilder({ page }).analyze();
        expect(violations).toEqual([]);
      });
    });
  }
}
