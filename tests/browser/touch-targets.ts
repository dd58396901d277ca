/** Sizes and overlaps of controls on touch screens. */

import type { Locator } from "@playwright/test";
import { type App, expect } from "./app";
import { readLabels } from "./labels";

/** The buttons for edits above the view. */
export const editBar = (app: App) => app.page.getByRole("group", { name: "Edit", exact: true });

/** Opens a clip and taps the second plant of the left foot. Returns its frames, the end exclusive. */
export async function tapPlant(app: App) {
  await app.openSample("curved-walk");
  return tapSecondPlant(app);
}

/** Taps the second plant of the left foot. Returns its frames, the end exclusive. */
export async function tapSecondPlant(app: App) {
  const plant = readLabels(await app.save("Labels")).left.contact?.[1];
  if (!plant) throw new Error("There is no second plant.");
  const lower = app.page.getByRole("button", { name: "Collapse panel" });
  if (await lower.isVisible()) await lower.tap();
  const box = await app.tracks.boundingBox();
  if (!box) throw new Error("The timeline has no canvas.");
  const labelWidth = box.width <= 560 ? 100 : 118;
  const frames = (await app.lastFrame()) + 1;
  const position = (plant.start + plant.end) / 2 / frames;
  const x = box.x + labelWidth + position * (box.width - labelWidth - 14);
  await app.page.touchscreen.tap(x, box.y + 48);
  await expect(editBar(app)).toBeVisible();
  return plant;
}

/** Returns the area that two elements share, in square pixels; 0 if one is not visible. */
export async function overlap(first: Locator, second: Locator): Promise<number> {
  if (!(await first.isVisible()) || !(await second.isVisible())) return 0;
  const [a, b] = [await first.boundingBox(), await second.boundingBox()];
  if (!a || !b) return 0;
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return Math.min(width, height) > 0.5 ? width * height : 0;
}

/** Returns the controls whose area for touch is lower than 44 pixels. */
export async function smallTargets(app: App): Promise<string[]> {
  // Tables for screen readers are not visible; tapping a tab does the same as the handle of the sheet.
  const controls = app.page.locator(
    ":is(button, select, input):visible:not(.visually-hidden *, .sheet-handle)",
  );
  const sizes = await controls.evaluateAll((elements) =>
    // A list may have replaced its rows since they were found.
    elements
      .filter((element) => element.isConnected)
      .map((element) => {
        // A label is part of the control.
        const { height } = (element.closest("label") ?? element).getBoundingClientRect();
        // The area in the camera controls of a low view is higher than what is displayed.
        const area = Number.parseFloat(getComputedStyle(element, "::before").height) || 0;
        const name = element.getAttribute("aria-label") ?? element.textContent;
        return {
          name: `${name} (${element.className})`,
          height: Math.round(Math.max(height, area)),
        };
      }),
  );
  expect(sizes.length).toBeGreaterThan(10);
  return sizes.filter(({ height }) => height < 44).map(({ name, height }) => `${name}: ${height}`);
}
