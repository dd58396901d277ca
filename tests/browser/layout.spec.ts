/** The layout and colours of the page with every sample, on a desktop and a phone, light and dark. */

import type { Locator } from "@playwright/test";
import { type App, expect, test } from "./app";
import { recorded, samples } from "./clips";
import { readTable, type Table } from "./labels";

/** Positions on the timeline, from its left edge (0) to its right one (1). */
const moments = [0.35, 0.6, 0.85];

const devices = {
  desktop: { width: 1440, height: 900 },
  phone: { width: 390, height: 844 },
} as const;

/** Least contrast of text, and of graphics, by WCAG 2.2 (1.4.3, 1.4.11). */
const textContrast = 4.5;
const graphicsContrast = 3;

for (const [i, { name, title }] of samples.entries()) {
  test(`${title}: layout, colours and labels`, async ({ app }) => {
    await app.openSample(name);
    await expectLooks(app, i);
  });
}

const recordings = [
  "cmu/86_01",
  "cmu/131_03",
  "dialects/bandai_dataset-1_run_tired_001",
  "dialects/rokoko_jesse_dance",
  "dialects/pybvh_example_zup",
  "dialects/freebvh_mixamo",
];

for (const [i, path] of recordings.entries()) {
  test(`recording ${path}: layout, colours and labels`, async ({ app, page }) => {
    const file = recorded(`${path}.bvh`);
    test.skip(!file, "No recorded motion was found. Set PLANTIGRADE_CORPUS to its folder.");
    if (!file) return;
    await app.openStartPage();
    await page.locator("input[type=file]").setInputFiles(file);
    await app.waitForClip(`${path.replace(/^.*\//, "")}.bvh`);
    await expectLooks(app, i);
  });
}

/** Checks the page on both devices, one of them light and the other dark. */
async function expectLooks(app: App, index: number) {
  const { page } = app;
  const table = readTable(await app.save("Every frame"));
  await app.tab("Detect");
  for (const [j, viewport] of Object.values(devices).entries()) {
    const theme = (index + j) % 2 ? "light" : "dark";
    await page.setViewportSize(viewport);
    await page.emulateMedia({ colorScheme: theme });
    await expect(page.locator("html")).toHaveAttribute("data-theme", theme);
    // Selecting a tab expands the panel on a phone.
    const collapse = page.getByRole("button", { name: "Collapse panel" });
    if (await collapse.isVisible()) await collapse.click();
    await expectColours(app, theme);
    await page.keyboard.press("Home");
    let before = { frame: 0, picture: "", boxes: "" };
    for (const moment of moments) {
      const frame = await app.pressRuler(moment);
      expect(frame).toBeGreaterThan(before.frame);
      await expectPills(app, table);
      const boxes = await expectLayout(app);
      if (before.boxes) expect(boxes).toBe(before.boxes);
      const picture = await app.stillPicture();
      expect(picture === before.picture, "the picture shows another moment").toBe(false);
      before = { frame, picture, boxes };
    }
  }
}

/** Nothing overflows or overlaps. Returns the boxes of the regions, which must not change. */
async function expectLayout(app: App): Promise<string> {
  const { page } = app;
  const overflow = await page.evaluate(() => {
    const { scrollWidth, clientWidth, scrollHeight, clientHeight } = document.documentElement;
    return [scrollWidth - clientWidth, scrollHeight - clientHeight];
  });
  expect(overflow).toEqual([0, 0]);
  const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
  const regions = await boxesOf([app.head, app.stage, app.timeline]);
  for (const box of regions) {
    expect(box.x).toBeGreaterThanOrEqual(0);
    expect(box.y).toBeGreaterThanOrEqual(0);
    expect(box.x + box.width).toBeLessThanOrEqual(width);
    expect(box.y + box.height).toBeLessThanOrEqual(height);
  }
  expectDisjoint(regions);
  const pills = await app.view.locator(".pill").all();
  expectDisjoint(await boxesOf([app.view.getByRole("group", { name: "Camera" }), ...pills]));
  expectDisjoint(await boxesOf(await app.timeline.locator(".transport-part > *:visible").all()));
  return JSON.stringify(regions);
}

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

async function boxesOf(elements: readonly Locator[]): Promise<Box[]> {
  const boxes = await Promise.all(elements.map((element) => element.boundingBox()));
  return boxes.filter((box) => box !== null);
}

/** Fails if boxes overlap by more than half a pixel. */
function expectDisjoint(boxes: readonly Box[]) {
  for (const [i, a] of boxes.entries()) {
    for (const b of boxes.slice(i + 1)) {
      const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
      const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
      expect(Math.min(width, height), `${JSON.stringify(a)} ${JSON.stringify(b)}`).toBeLessThan(
        0.5,
      );
    }
  }
}

/** The theme is applied, and what is drawn on canvases, which axe cannot see, has contrast. */
async function expectColours(app: App, theme: "light" | "dark") {
  const contrast = await app.page.evaluate(() => {
    const style = getComputedStyle(document.documentElement);
    const luminance = (name: string) => {
      const probe = document.createElement("canvas").getContext("2d");
      if (!probe) return 0;
      probe.fillStyle = style.getPropertyValue(name).trim();
      probe.fillRect(0, 0, 1, 1);
      const [r = 0, g = 0, b = 0] = [...probe.getImageData(0, 0, 1, 1).data].map((value) => {
        const c = value / 255;
        return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
      });
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const ratio = (a: string, b: string) => {
      const [x, y] = [luminance(a), luminance(b)];
      return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
    };
    return {
      isDark: luminance("--panel") < 0.2,
      text: [
        ratio("--text", "--panel"),
        ratio("--muted", "--panel"),
        ratio("--text-on-side", "--left"),
        ratio("--text-on-side", "--right"),
      ],
      graphics: [
        ratio("--left", "--lane"),
        ratio("--right", "--lane"),
        ratio("--accent", "--lane"),
        ratio("--difference", "--lane"),
        ratio("--border-strong", "--panel"),
        ratio("--view-bone", "--view-background"),
      ],
    };
  });
  expect(contrast.isDark).toBe(theme === "dark");
  expect(Math.min(...contrast.text)).toBeGreaterThanOrEqual(textContrast);
  expect(Math.min(...contrast.graphics)).toBeGreaterThanOrEqual(graphicsContrast);
}

/** The status of each foot agrees with the row of the frame in the saved table. */
async function expectPills(app: App, { rows }: Table) {
  const row = rows[await app.frame()];
  for (const [side, name] of [
    ["left", "Left"],
    ["right", "Right"],
  ] as const) {
    const words = row?.[`${side}_contact`] === "1" ? "in contact" : "in the air";
    await expect(app.view.getByText(new RegExp(`^${name} (in contact|in the air)`))).toContainText(
      words,
    );
  }
}
