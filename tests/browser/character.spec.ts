/** Controls and cards do not cover the character of the 3D view. */

import { type App, expect, test } from "./app";
import { atEachSize, onPhones, onTablets, tablets, viewports } from "./viewports";

type Place = [x: number, y: number];

/** Hides or shows elements in front of the view. */
const show = (app: App, selector: string, isShown: boolean) =>
  app.page.locator(selector).evaluateAll(
    (elements, visibility) => {
      for (const element of elements) (element as HTMLElement).style.visibility = visibility;
    },
    isShown ? "" : "hidden",
  );

/** Returns the places on the page where the view without these elements has lit feet or dark bones. */
async function placesOf(app: App, part: "feet" | "bones", overlays: string): Promise<Place[]> {
  const stage = await app.stage.boundingBox();
  if (!stage) throw new Error("There is no view.");
  await show(app, overlays, false);
  const picture = await app.stillPicture();
  await show(app, overlays, true);
  const places = await app.page.evaluate(
    async ({ data, isFeet }) => {
      const image = new Image();
      image.src = `data:image/png;base64,${data}`;
      await image.decode();
      const { width, height } = image;
      const ctx = new OffscreenCanvas(width, height).getContext("2d");
      ctx?.drawImage(image, 0, 0);
      const pixels = ctx?.getImageData(0, 0, width, height).data ?? [];
      const found: [number, number][] = [];
      for (let i = 0; i < pixels.length; i += 4) {
        const [r = 0, g = 0, b = 0] = [pixels[i], pixels[i + 1], pixels[i + 2]];
        const isPart = isFeet ? Math.abs(r - b) > 120 : Math.max(r, g, b) < 115;
        if (isPart) found.push([(i / 4) % width, Math.floor(i / 4 / width)]);
      }
      return found;
    },
    { data: picture, isFeet: part === "feet" },
  );
  return places.map(([x, y]) => [stage.x + x, stage.y + y]);
}

/** Returns the places that elements cover, or would cover if they were larger by a margin. */
async function coveredBy(
  app: App,
  selector: string,
  places: readonly Place[],
  margin = 0,
): Promise<Place[]> {
  const boxes = await app.page
    .locator(selector)
    .evaluateAll((elements) =>
      elements
        .filter((element) => element.checkVisibility())
        .map((element) => element.getBoundingClientRect().toJSON() as DOMRect),
    );
  expect(boxes.length).toBeGreaterThan(0);
  return places.filter(([x, y]) =>
    boxes.some(
      ({ left, right, top, bottom }) =>
        x > left - margin && x < right + margin && y > top - margin && y < bottom + margin,
    ),
  );
}

test("the gallery does not cover the feet of the preview", async ({ app, page }) => {
  await app.openStartPage();
  const window = { width: 800, height: 700 };
  for (const viewport of [...Object.values(viewports), ...Object.values(tablets), window]) {
    await page.setViewportSize(viewport);
    const feet = await placesOf(app, "feet", ".start-page");
    expect(feet.length).toBeGreaterThan(100);
    expect(await coveredBy(app, ".card", feet), JSON.stringify(viewport)).toEqual([]);
    const bones = await placesOf(app, "bones", ".start-page");
    const text = ".card, .start-page .button, .start-page .muted, .start-page h2";
    expect(await coveredBy(app, text, bones), JSON.stringify(viewport)).toEqual([]);
  }
});

function controlsLeaveCharacterFree() {
  test("the controls of the view do not cover the character", async ({ app, page }) => {
    await app.openSample("curved-walk");
    const expectFree = async () => {
      const bones = await placesOf(app, "bones", ".viewer > :not(.stage)");
      expect(bones.length).toBeGreaterThan(50);
      const controls = ".viewer-tools > *, .frame-steps, .pill";
      expect(await coveredBy(app, controls, bones, 4)).toEqual([]);
    };
    await expectFree();
    // The raised sheet of a phone leaves less height.
    if (await page.getByRole("tabpanel").isVisible()) return;
    await app.tab("Detect");
    await expectFree();
  });
}

atEachSize(controlsLeaveCharacterFree);
onPhones(controlsLeaveCharacterFree);
onTablets(controlsLeaveCharacterFree);
