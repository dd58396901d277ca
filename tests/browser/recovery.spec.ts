/** Recovery from traps of the core, oversized files and a blocked page. */

import { type App, expect, test } from "./app";
import { sample } from "./clips";
import { readLabels } from "./labels";

const spans = async (app: App) => readLabels(await app.save("Labels")).left.contact;

test("replaces the worker after a trap and preserves edits", async ({ app, page }) => {
  // In the first worker, measuring gait traps.
  await page.addInitScript(() => {
    const Real = globalThis.Worker;
    const trap = `
      const real = WebAssembly.instantiate;
      WebAssembly.instantiate = async (module, imports) => {
        const instance = await real(module, imports);
        const trap = () => { throw new WebAssembly.RuntimeError("unreachable"); };
        const exports = { ...instance.exports, wasmclip_gait: trap };
        return { instance: { exports }, module };
      };`;
    let isFirst = true;
    globalThis.Worker = class extends Real {
      constructor(url: string | URL, options?: WorkerOptions) {
        if (!isFirst) {
          super(url, options);
          return;
        }
        isFirst = false;
        const code = `${trap}\nawait import(${JSON.stringify(String(new URL(url, location.href)))});`;
        // Messages that arrive before the module runs are queued.
        const script = `const early = []; const queue = (e) => early.push(e); addEventListener("message", queue);
          ${code}
          removeEventListener("message", queue); for (const e of early) dispatchEvent(new MessageEvent("message", { data: e.data, ports: [...e.ports], origin: e.origin }));`;
        super(URL.createObjectURL(new Blob([script], { type: "text/javascript" })), options);
      }
    };
  });
  await app.openSample("curved-walk");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect.poll(async () => (await spans(app))?.length).toBe(2);
  await app.tab("Clip");
  await expect(app.alert).toContainText("curved-walk.bvh could not be measured");
  await expect(app.alert).toContainText("your edits were not lost");
  await app.alert.getByRole("button", { name: "Dismiss" }).click();
  // The new worker has restored the clip and the edits.
  await expect.poll(async () => (await spans(app))?.length).toBe(2);
  await app.tab("Clip");
  await expect(app.panel.getByRole("table", { name: "Gait" })).toBeVisible();
});

test("refuses a file of two gigabytes before reading it", async ({ app, page }) => {
  await app.openSample("curved-walk");
  await page.evaluate(() => {
    const part = new Blob([new Uint8Array(2 ** 26)]);
    const huge = new File(Array(32).fill(part), "huge.bvh");
    const transfer = new DataTransfer();
    transfer.items.add(huge);
    document.body.dispatchEvent(
      new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }),
    );
  });
  await expect(app.alert).toContainText("huge.bvh could not be opened");
  await expect(app.alert).toContainText("the limit is 1.07 GB");
  await expect(app.alert).toContainText("curved-walk.bvh is still open");
  await app.drop(sample("bowling"));
  await app.waitForClip("bowling.bvh");
});

test("does not skip frames after the page was blocked", async ({ app, page }) => {
  await app.openSample("limp-to-run");
  await page.keyboard.press("Space");
  const [before, after] = await page.evaluate(async () => {
    const now = () =>
      Number(document.querySelector("[role=slider]")?.getAttribute("aria-valuenow"));
    const drawn = () => new Promise(requestAnimationFrame);
    await drawn();
    const before = now();
    // Simulates a suspended tab: no animation frames for three seconds.
    const end = performance.now() + 3000;
    while (performance.now() < end);
    await drawn();
    await drawn();
    return [before, now()] as const;
  });
  // Playback catches up by a quarter of a second at most.
  expect(after - before).toBeLessThan(24);
  await expect.poll(() => app.frame()).toBeGreaterThan(after);
});
