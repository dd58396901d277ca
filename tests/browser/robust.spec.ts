/** What must not take the page along: a fault of the program, files beyond all measure, sleep. */

import { type App, expect, test } from "./app";
import { sample } from "./clips";
import { readLabels } from "./labels";

const spans = async (app: App) => readLabels(await app.save("Labels")).left.contact;

test("a fault in the core replaces the worker, and edits are kept", async ({ app, page }) => {
  // Measuring gait reaches an instruction that traps, once.
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
        // What comes before the module runs waits for it.
        const held = `const early = []; const keep = (e) => early.push(e); addEventListener("message", keep);
          ${code}
          removeEventListener("message", keep); for (const e of early) dispatchEvent(new MessageEvent("message", { data: e.data, ports: [...e.ports], origin: e.origin }));`;
        super(URL.createObjectURL(new Blob([held], { type: "text/javascript" })), options);
      }
    };
  });
  await app.sample("curved-walk");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect.poll(async () => (await spans(app))?.length).toBe(2);
  await app.tab("Clip");
  await expect(app.alert).toContainText("curved-walk.bvh could not be measured");
  await expect(app.alert).toContainText("your edits were not lost");
  await app.alert.getByRole("button", { name: "Dismiss" }).click();
  // The next worker has the clip and the edits again.
  await expect.poll(async () => (await spans(app))?.length).toBe(2);
  await app.tab("Clip");
  await expect(app.panel.getByRole("table", { name: "Gait" })).toBeVisible();
});

test("a file of two gigabytes is refused before it is read", async ({ app, page }) => {
  await app.sample("curved-walk");
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
  await app.opened("bowling.bvh");
});

test("a page that was held up goes on where it was", async ({ app, page }) => {
  await app.sample("limp-to-run");
  await page.keyboard.press("Space");
  const [before, after] = await page.evaluate(async () => {
    const now = () =>
      Number(document.querySelector("[role=slider]")?.getAttribute("aria-valuenow"));
    const drawn = () => new Promise(requestAnimationFrame);
    await drawn();
    const before = now();
    // As a tab that sleeps: no picture for three seconds.
    const end = performance.now() + 3000;
    while (performance.now() < end);
    await drawn();
    await drawn();
    return [before, now()] as const;
  });
  // At most a quarter of a second of it is made up for.
  expect(after - before).toBeLessThan(24);
  await expect.poll(() => app.frame()).toBeGreaterThan(after);
});
