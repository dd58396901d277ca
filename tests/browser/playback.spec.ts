import { expect, test } from "./app";

test("plays by Space and pauses by button", async ({ app, page }) => {
  await app.openSample("bowling");
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
  await app.openSample("limp-to-run");
  await page.keyboard.press("Space");
  await expect.poll(() => app.frame()).toBeGreaterThan(0);
  // Playback does not catch up on long pauses between animation frames; they are excluded.
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

test("steps frames and jumps to both ends by key", async ({ app, page }) => {
  await app.openSample("bowling");
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

test("changes the speed by comma and full stop", async ({ app, page }) => {
  await app.openSample("bowling");
  const speed = app.timeline.getByRole("combobox", { name: "Speed" });
  await expect(speed).toHaveValue("1");
  await page.keyboard.press(">");
  await expect(speed).toHaveValue("1.5");
  await page.keyboard.press("<");
  await page.keyboard.press("<");
  await expect(speed).toHaveValue("0.75");
  await speed.selectOption("4");
  await page.keyboard.press(">");
  await expect(speed).toHaveValue("4");
});

test("cycles loop modes by L", async ({ app, page }) => {
  await app.openSample("bowling");
  const loop = app.timeline.getByRole("button", { name: /^Loop/ });
  await expect(loop).toHaveText("Loop clip");
  await page.keyboard.press("Shift+l");
  await expect(loop).toHaveText(/^Loop plant \d+$/);
  await page.keyboard.press("Shift+l");
  await expect(loop).toHaveText("Loop segment 1");
  await page.keyboard.press("Shift+l");
  await expect(loop).toHaveText("Loop off");
  await expect(loop).toHaveAttribute("aria-pressed", "false");
  await page.keyboard.press("Shift+l");
  await expect(loop).toHaveText("Loop clip");
});

test("loops the selected plant, not another one at the playhead", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await app.tab("Labels");
  await page.keyboard.press("e");
  const number = (await app.panel.getByRole("button", { pressed: true }).innerText()).split(
    /\s/,
  )[0];
  await page.keyboard.press("End");
  await page.keyboard.press("Shift+l");
  const loop = app.timeline.getByRole("button", { name: `Loop plant ${number}`, exact: true });
  await expect(loop).toBeVisible();
  const last = app.panel.getByRole("spinbutton", { name: "Last frame" });
  await last.fill(String(Number(await last.inputValue()) + 2));
  await page.keyboard.press("Enter");
  await expect(app.head.getByText("edited")).toBeVisible();
  await expect(loop).toBeVisible();
});

test("stops at the last frame without a loop", async ({ app, page }) => {
  await app.openSample("bowling");
  for (let i = 0; i < 3; i++) await page.keyboard.press("Shift+l");
  await page.keyboard.press("End");
  for (let i = 0; i < 10; i++) await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Space");
  await expect(app.playhead).toHaveAttribute("aria-valuenow", "315");
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeVisible();
});
