/** The camera, on pages of every size. */

import { type App, expect, test } from "./app";
import { atEachSize } from "./viewports";

/** Returns the camera pose in the link to the current view. */
async function pose(app: App) {
  const view = new URLSearchParams(new URL(await app.link()).hash.slice(1));
  const point = (key: string) => {
    const [x = Number.NaN, y = Number.NaN, z = Number.NaN] =
      view.get(key)?.split(",").map(Number) ?? [];
    return { x, y, z };
  };
  return { eye: point("eye"), at: point("at") };
}

type Point = Awaited<ReturnType<typeof pose>>["at"];
const distance = (a: Point, b: Point) => Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z);

/** Turns the wheel over a point of the view: 0 is its left edge, 1 the right one. */
async function zoomAt(app: App, position: number, by: number) {
  const box = await app.stage.boundingBox();
  if (!box) throw new Error("There is no view.");
  await app.page.mouse.move(box.x + position * box.width, box.y + 0.5 * box.height);
  await app.page.mouse.wheel(0, by);
  await app.stillPicture();
}

atEachSize(() => {
  test("turns the camera and shows the feet close up, by keys and by buttons", async ({
    app,
    page,
  }) => {
    await app.openSample("curved-walk");
    await test.step("turns the camera by keys 1 to 4 and by buttons", async () => {
      for (const [i, name] of ["Perspective", "Front", "Side", "Top"].entries()) {
        await page.keyboard.press(String(i + 1));
        const pressed = app.view.getByRole("button", { name, pressed: true });
        await expect(pressed).toBeVisible();
      }
      await app.view.getByRole("button", { name: "Front" }).click();
      await expect(app.view.getByRole("button", { name: "Front", pressed: true })).toBeVisible();
      await expect(app.view.getByRole("button", { name: "Top", pressed: false })).toBeVisible();
    });
    await test.step("shows the feet close up by a key and by a button", async () => {
      for (const show of [
        () => page.keyboard.press("5"),
        () => app.view.getByRole("button", { name: "Feet" }).click(),
      ]) {
        await page.keyboard.press("f");
        await show();
        await app.stillPicture();
        const { eye, at } = await pose(app);
        expect(at.y).toBeLessThan(0.3);
        expect(distance(eye, at)).toBeLessThan(4);
      }
    });
  });

  test("zooms at the pointer", async ({ app }) => {
    await app.openSample("curved-walk");
    await zoomAt(app, 0.3, -400);
    const onLeft = await pose(app);
    await app.page.reload();
    await app.waitForClip("curved-walk.bvh");
    await zoomAt(app, 0.7, -400);
    const onRight = await pose(app);
    expect(distance(onLeft.at, onRight.at)).toBeGreaterThan(0.2);
  });
});
