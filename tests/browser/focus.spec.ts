/** Keys belong to the timeline, whichever control was used last. */

import { expect, test } from "./app";
import { bad, sample } from "./clips";
import { atEachSize } from "./viewports";

atEachSize(() => {
  test("keys belong to the timeline after a menu, a number and a press", async ({ app, page }) => {
    await app.openSample("curved-walk");
    await test.step("keys step frames after a menu was used with the pointer", async () => {
      await app.tab("Detect");
      const method = page.getByRole("combobox", { name: "Method" });
      await method.click();
      await page.keyboard.press("ArrowDown");
      await page.keyboard.press("Enter");
      const chosen = await method.inputValue();
      await page.keyboard.press("ArrowRight");
      await expect.poll(() => app.frame()).toBe(1);
      await page.keyboard.press(".");
      await expect.poll(() => app.frame()).toBe(2);
      await expect(method).toHaveValue(chosen);
      await page.keyboard.press("Home");
    });
    await test.step("keys step frames after a number was entered", async () => {
      await app.tab("Labels");
      await page.keyboard.press("e");
      const last = app.panel.getByRole("spinbutton", { name: "Last frame" });
      await last.fill("50");
      await page.keyboard.press("Enter");
      await expect(last).toHaveValue("50");
      await page.keyboard.press("ArrowRight");
      await expect.poll(() => app.frame()).toBe(1);
      await expect(last).toHaveValue("50");
    });
    await test.step("the timeline and the view take the focus when they are pressed", async () => {
      await app.tab("Labels");
      await page.keyboard.press("e");
      const last = app.panel.getByRole("spinbutton", { name: "Last frame" });
      for (const press of [
        () => app.pressRuler(0.5),
        async () => {
          const box = await app.stage.boundingBox();
          if (box) await page.mouse.click(box.x + 0.8 * box.width, box.y + 0.6 * box.height);
        },
      ]) {
        await last.click();
        await expect(last).toBeFocused();
        await press();
        await expect(last).not.toBeFocused();
        await page.keyboard.press("Home");
        await page.keyboard.press("ArrowRight");
        await expect.poll(() => app.frame()).toBe(1);
      }
    });
  });

  test("every step of the sensitivity slider changes it", async ({ app, page }) => {
    await app.openSample("curved-walk");
    await app.tab("Detect");
    const slider = page.getByRole("slider", { name: "Sensitivity r" });
    await slider.focus();
    const seen = new Set([await slider.getAttribute("aria-valuetext")]);
    for (let i = 1; i <= 12; i++) {
      await page.keyboard.press(i > 6 ? "ArrowLeft" : "ArrowRight");
      if (i <= 6) {
        await expect
          .poll(async () => seen.has(await slider.getAttribute("aria-valuetext")))
          .toBe(false);
        seen.add(await slider.getAttribute("aria-valuetext"));
      }
    }
    await expect(slider).toHaveAttribute("aria-valuetext", "r 0.001");
  });
});

test("single letters never reach a menu that has the focus", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const method = page.getByRole("combobox", { name: "Method" });
  await method.focus();
  const before = await method.inputValue();
  // The names of other methods begin with these letters.
  for (const key of ["n", "f", "s"]) await page.keyboard.press(key);
  await expect(method).toHaveValue(before);
  await page.keyboard.press("l");
  await expect(app.timeline.getByRole("button", { name: "Pause" })).toBeVisible();
  await page.keyboard.press("k");
  await expect(app.timeline.getByRole("button", { name: "Play" })).toBeVisible();
});

test("keys of the menu itself work after it was reached by keyboard", async ({ app, page }) => {
  await app.openSample("curved-walk");
  const speed = app.timeline.getByRole("combobox", { name: "Speed" });
  await app.timeline.getByRole("button", { name: /^Loop/ }).focus();
  await page.keyboard.press("Tab");
  await expect(speed).toBeFocused();
  await page.keyboard.press("ArrowDown");
  await expect(speed).toHaveValue("1.5");
  expect(await app.frame()).toBe(0);
});

test("has the former keys as a choice, which is remembered", async ({ app, page }) => {
  await app.openSample("bowling");
  await page.keyboard.press("?");
  await app.dialog.getByRole("checkbox", { name: /^Former keys/ }).check();
  await expect(app.dialog.getByText("Loop: clip, plant, segment, off")).toBeVisible();
  await page.keyboard.press("Escape");
  await page.reload();
  await app.waitForClip("bowling.bvh");
  await page.keyboard.press("l");
  await expect(app.timeline.getByRole("button", { name: /^Loop plant/ })).toBeVisible();
});

test("plays backwards and faster by J and L", async ({ app, page }) => {
  await app.openSample("bowling");
  await page.keyboard.press("End");
  const speed = app.timeline.getByRole("combobox", { name: "Speed" });
  await page.keyboard.press("j");
  await expect(app.timeline.getByText("reverse")).toBeVisible();
  await expect.poll(() => app.frame()).toBeLessThan(310);
  await page.keyboard.press("j");
  await expect(speed).toHaveValue("1.5");
  await page.keyboard.press("k");
  const paused = await app.frame();
  await page.keyboard.press("l");
  await expect(speed).toHaveValue("1");
  await expect.poll(() => app.frame()).toBeGreaterThan(paused);
});

test("a pressed button that disappears or is disabled gives the focus to its neighbour", async ({
  app,
  page,
}) => {
  await app.openSample("curved-walk");
  await app.tab("Labels");
  await page.keyboard.press("e");
  const button = (name: string) => app.panel.getByRole("button", { name, exact: true });
  const undo = button("Undo");
  await button("Delete").focus();
  await page.keyboard.press("Enter");
  await expect(undo).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(undo).toBeDisabled();
  await expect(button("Redo")).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(undo).toBeFocused();
});

test("hiding the panel by keyboard gives the focus to the timeline", async ({ app, page }) => {
  await app.openSample("curved-walk");
  for (const control of [
    app.panel.getByRole("slider").first(),
    page.getByRole("tab", { name: "Detect" }),
  ]) {
    await control.focus();
    await page.keyboard.press("p");
    await expect(control).toBeHidden();
    await expect(app.playhead).toBeFocused();
    await page.keyboard.press("p");
    await expect(control).toBeVisible();
  }
});

test("closing a table, a card or a dialog by keyboard gives the focus to the page", async ({
  app,
  page,
}) => {
  await app.openStartPage();
  await app.drop(sample("bowling"), sample("curved-walk"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await test.step("opening a row focuses the playhead", async () => {
    await page.getByRole("button", { name: "bowling.bvh", exact: true }).focus();
    await page.keyboard.press("Enter");
    await app.waitForClip("bowling.bvh");
    await expect(app.playhead).toBeFocused();
  });
  const table = page.getByRole("region", { name: /clips$/ });
  await test.step("closing the share dialog leaves the focus in the table", async () => {
    await app.head.getByRole("button", { name: "2 clips" }).focus();
    await page.keyboard.press("Enter");
    await expect(table).toBeFocused();
    await app.head.getByRole("button", { name: "Share" }).click();
    await expect(app.dialog).toBeVisible();
    await page.keyboard.press("Escape");
    await expect(app.dialog).toBeHidden();
    await expect(table).toBeFocused();
  });
  await test.step("closing the table focuses the playhead", async () => {
    await table.getByRole("button", { name: /^Back to/ }).focus();
    await page.keyboard.press("Enter");
    await expect(table).toBeHidden();
    await expect(app.playhead).toBeFocused();
  });
  await test.step("dismissing an error focuses the playhead", async () => {
    await app.drop(bad("not-a-number"));
    await app.alert.getByRole("button", { name: "Dismiss" }).focus();
    await page.keyboard.press("Enter");
    await expect(app.alert).toBeHidden();
    await expect(app.playhead).toBeFocused();
  });
  await test.step("on the start page, the focus stays on the page", async () => {
    await app.head.getByRole("button", { name: "Plantigrade, start page" }).click();
    await app.drop(bad("not-a-number"));
    await app.alert.getByRole("button", { name: "Dismiss" }).focus();
    await page.keyboard.press("Enter");
    await expect(app.alert).toBeHidden();
    await expect(page.locator(":focus")).toBeVisible();
  });
});
