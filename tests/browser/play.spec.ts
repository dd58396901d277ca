import { expect, test } from "./app";

test("Space plays and the button pauses", async ({ app, page }) => {
  await app.sample("bowling");
  await page.keyboard.press("Space");
  const pause = app.timeline.getByRole("button", { name: "Pause" });
  await expect(pause).toBeVisible();
  await expect.poll(() => app.frame()).toBeGreaterThan(5);
  await pause.click();
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeVisible();
  const paused = await app.frame();
  await app.animationFrames(10);
  expect(await app.frame()).toBe(paused);
});

test("plays in real time", async ({ app, page }) => {
  test.slow();
  await app.sample("limp-to-run");
  await page.keyboard.press("Space");
  await expect.poll(() => app.frame()).toBeGreaterThan(0);
  // Pauses between animation frames that are longer than playback makes up for are left out.
  const rate = await page.evaluate(async () => {
    const frameNow = () =>
      Number(document.querySelector("[role=slider]")?.getAttribute("aria-valuenow"));
    const nextTime = () => new Promise<number>(requestAnimationFrame);
    let [frames, seconds] = [0, 0];
    let [frame, time] = [frameNow(), await nextTime()];
    while (frames < 96) {
      const [nextFrame, now] = [frameNow(), await nextTime()];
      const elapsed = (now - time) / 1000;
      if (nextFrame >= frame && elapsed < 0.25) {
        frames += nextFrame - frame;
        seconds += elapsed;
      }
      [frame, time] = [nextFrame, now];
    }
    return frames / seconds;
  });
  expect(rate).toBeGreaterThan(24 * 0.8);
  expect(rate).toBeLessThan(24 * 1.2);
});

test("keys step and go to the first and last frame", async ({ app, page }) => {
  await app.sample("bowling");
  const go = async (key: string) => {
    await page.keyboard.press(key);
    return app.frame();
  };
  expect(await go("End")).toBe(315);
  expect(await go("ArrowRight")).toBe(315);
  expect(await go("ArrowLeft")).toBe(314);
  expect(await go("Home")).toBe(0);
  expect(await go("ArrowRight")).toBe(1);
});

test("comma and full stop change the speed", async ({ app, page }) => {
  await app.sample("bowling");
  const speed = app.timeline.getByRole("combobox", { name: "Speed" });
  await expect(speed).toHaveValue("1");
  await page.keyboard.press(".");
  await expect(speed).toHaveValue("1.5");
  await page.keyboard.press(",");
  await page.keyboard.press(",");
  await expect(speed).toHaveValue("0.75");
  await speed.selectOption("4");
  await page.keyboard.press(".");
  await expect(speed).toHaveValue("4");
});

test("L loops the clip, then a plant, then a segment, then nothing", async ({ app, page }) => {
  await app.sample("bowling");
  const loop = app.timeline.getByRole("button", { name: /^Loop/ });
  await expect(loop).toHaveText("Loop clip");
  await page.keyboard.press("l");
  await expect(loop).toHaveText(/^Loop plant \d+$/);
  await page.keyboard.press("l");
  await expect(loop).toHaveText("Loop segment 1");
  await page.keyboard.press("l");
  await expect(loop).toHaveText("Loop off");
  await expect(loop).toHaveAttribute("aria-pressed", "false");
  await page.keyboard.press("l");
  await expect(loop).toHaveText("Loop clip");
});

test("without a loop a clip plays to its end and stays there", async ({ app, page }) => {
  await app.sample("bowling");
  for (let i = 0; i < 3; i++) await page.keyboard.press("l");
  await page.keyboard.press("End");
  for (let i = 0; i < 10; i++) await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Space");
  await expect(app.playhead).toHaveAttribute("aria-valuenow", "315");
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeVisible();
});
