/** Workers that end, trap or do not start: the page reports it, goes on, and preserves edits. */

import type { Page } from "@playwright/test";
import { unzipSync, zipSync } from "fflate";
import { type App, expect, test } from "./app";
import { sample } from "./clips";
import { readLabels } from "./labels";

const plants = async (app: App) => readLabels(await app.save("Labels")).left.contact?.length;

/** A method of the worker API, at whose call the worker is ended. */
type Moment = "start" | "open" | "detect" | "segment" | "edit" | "save" | "summarize" | "unpack";

/**
 * Ends one worker without any event, as a browser does that lacks memory: at a call of a method,
 * after `skipped` other calls of it.
 */
async function endWorker(page: Page, moment: Moment, skipped = 0) {
  await page.addInitScript(
    ([moment, skipped]) => {
      let left = skipped;
      // Not again after a reload.
      let isEnded = sessionStorage.getItem("ended") !== null;
      let count = 0;
      const Real = globalThis.Worker;
      globalThis.Worker = class extends Real {
        constructor(url: string | URL, options?: WorkerOptions) {
          super(url, options);
          count++;
          if (moment === "start" && !isEnded) this.terminate();
          isEnded ||= moment === "start";
        }
        override postMessage(message: { path?: string[] }, options?: object) {
          if (message.path?.[0] !== moment || isEnded || left-- > 0) {
            super.postMessage(message, options);
            return;
          }
          isEnded = true;
          sessionStorage.setItem("ended", "");
          void this.terminateWhenStarted();
        }
        /** The page knows of the end of workers that have started; the others time out. */
        async terminateWhenStarted() {
          const name = (lock: LockInfo) => lock.name?.startsWith("plantigrade:worker:");
          for (;;) {
            const { pending = [] } = await navigator.locks.query();
            if (pending.filter(name).length === count) break;
            await new Promise(requestAnimationFrame);
          }
          this.terminate();
        }
      };
    },
    [moment, skipped] as const,
  );
}

/** Waits until no worker exists. */
const waitForEnd = (page: Page) =>
  expect
    .poll(() =>
      page.evaluate(async () => {
        const { held = [], pending = [] } = await navigator.locks.query();
        return held.length + pending.length;
      }),
    )
    .toBe(0);

test("reports a worker that ends while it reads a clip", async ({ app, page }) => {
  await endWorker(page, "open");
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await expect(app.alert).toContainText("curved-walk.bvh could not be opened");
  await expect(app.alert).toContainText("the worker was ended");
  await app.alert.getByRole("button", { name: "Try again" }).click();
  await app.waitForClip("curved-walk.bvh");
  expect(await plants(app)).toBe(3);
});

test("reports a worker that ends while it detects plants", async ({ app, page }) => {
  await endWorker(page, "detect");
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await app.waitForClip("curved-walk.bvh");
  await expect(app.timeline).toContainText("the worker was ended");
  await app.timeline.getByRole("button", { name: "Try again" }).click();
  await expect.poll(() => plants(app)).toBe(3);
});

test("reports a worker that ends while it segments", async ({ app, page }) => {
  await endWorker(page, "segment");
  await app.openSample("limp-to-run");
  await app.tab("Segment");
  await expect(app.panel).toContainText("the worker was ended");
  await app.panel.getByRole("button", { name: "Try again" }).click();
  expect((await app.segments()).length).toBeGreaterThan(1);
});

test("preserves an edit during which the worker ends", async ({ app, page }) => {
  await endWorker(page, "edit");
  await app.openSample("curved-walk");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect(app.alert).toContainText("curved-walk.bvh could not be edited");
  await expect(app.alert).toContainText("your edits were not lost");
  await app.alert.getByRole("button", { name: "Try again" }).click();
  await expect.poll(() => plants(app)).toBe(2);
  await page.reload();
  await app.waitForClip("curved-walk.bvh");
  await expect.poll(() => plants(app)).toBe(2);
});

test("repeats a save during which the worker ended", async ({ app, page }) => {
  await endWorker(page, "save");
  await app.openSample("curved-walk");
  await app.tab("Labels");
  await app.panel.getByRole("button", { name: "Save", exact: true }).click();
  await app.panel.getByRole("button", { name: /^Labels/ }).click();
  await expect(app.alert).toContainText("curved-walk.plants.json could not be saved");
  const saved = await app.download(() =>
    app.alert.getByRole("button", { name: "Try again" }).click(),
  );
  expect(readLabels(saved).left.contact).toHaveLength(3);
});

test("restores clip and edits after a worker ends while it is idle", async ({ app, page }) => {
  await page.addInitScript(() => {
    const Real = globalThis.Worker;
    const workers: Worker[] = [];
    Object.assign(globalThis, { workers });
    globalThis.Worker = class extends Real {
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options);
        workers.push(this);
      }
    };
  });
  await app.openSample("curved-walk");
  await page.keyboard.press("e");
  await page.keyboard.press("Delete");
  await expect.poll(() => plants(app)).toBe(2);
  await page.evaluate(() => {
    for (const worker of (globalThis as unknown as { workers: Worker[] }).workers)
      worker.terminate();
  });
  await waitForEnd(page);
  await expect.poll(() => plants(app)).toBe(2);
});

test("reports a worker that never starts", async ({ app, page }) => {
  test.setTimeout(120_000);
  await endWorker(page, "start");
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await expect(app.alert).toContainText("the worker did not start", { timeout: 40_000 });
  await app.alert.getByRole("button", { name: "Try again" }).click();
  await app.waitForClip("curved-walk.bvh");
});

test("reports a worker whose script cannot be loaded", async ({ app, page }) => {
  app.expectProblem(/console error: .*(404|500|worker)|failed request/i);
  let isBroken = true;
  await page.route(/clip\.worker/, (route) =>
    isBroken ? route.fulfill({ status: 500, body: "" }) : route.continue(),
  );
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await expect(app.alert).toContainText("the worker could not be loaded");
  isBroken = false;
  await app.alert.getByRole("button", { name: "Try again" }).click();
  await app.waitForClip("curved-walk.bvh");
});

test("reports a module that cannot be loaded", async ({ app, page }) => {
  app.expectProblem(/console error|console warning|failed request/i);
  let isBroken = true;
  await page.route(/\.wasm$/, (route) =>
    isBroken ? route.fulfill({ status: 500, body: "" }) : route.continue(),
  );
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await expect(app.alert).toContainText("its module could not be loaded");
  isBroken = false;
  await app.alert.getByRole("button", { name: "Try again" }).click();
  await app.waitForClip("curved-walk.bvh");
});

test("reports a lack of memory", async ({ app, page }) => {
  await page.addInitScript(() => {
    const Real = globalThis.Worker;
    let isFirst = true;
    globalThis.Worker = class extends Real {
      constructor(url: string | URL, options?: WorkerOptions) {
        const address = JSON.stringify(String(new URL(url, location.href)));
        // Messages that arrive before the module runs are queued.
        const script = `const early = []; const queue = (e) => early.push(e); addEventListener("message", queue);
          WebAssembly.instantiate = async () => { throw new RangeError("WebAssembly.instantiate(): Out of memory"); };
          await import(${address});
          removeEventListener("message", queue);
          for (const e of early) dispatchEvent(new MessageEvent("message", { data: e.data, ports: [...e.ports], origin: e.origin }));`;
        super(
          isFirst ? URL.createObjectURL(new Blob([script], { type: "text/javascript" })) : url,
          options,
        );
        isFirst = false;
      }
    };
  });
  await page.goto(`${app.site.home}#sample=curved-walk`);
  await expect(app.alert).toContainText("Out of memory");
  await app.alert.getByRole("button", { name: "Try again" }).click();
  await app.waitForClip("curved-walk.bvh");
});

test("goes on with a batch, and processes the failed file again", async ({ app, page }) => {
  await endWorker(page, "summarize");
  await app.openStartPage();
  await app.drop(sample("curved-walk"), sample("bowling"), sample("frog-jumps"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await expect(page.getByRole("row").filter({ hasText: "the worker was ended" })).toHaveCount(1);
  await page.getByRole("button", { name: "Try failed files again" }).click();
  await expect(page.getByRole("row").filter({ hasText: "the worker was ended" })).toHaveCount(0);
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await expect(page.getByRole("row").filter({ hasText: /\d Hz/ })).toHaveCount(3);
});

test("reports a worker that ends while it unpacks an archive", async ({ app, page }) => {
  await endWorker(page, "unpack");
  await app.openStartPage();
  const bytes = zipSync({ "walk.bvh": new Uint8Array(sample("curved-walk").buffer) });
  await app.drop({ name: "walks.zip", mimeType: "", buffer: Buffer.from(bytes) });
  await expect(app.alert).toContainText("walks.zip could not be opened");
  await app.alert.getByRole("button", { name: "Try again" }).click();
  await app.waitForClip("walk.bvh");
});

test("saves a complete archive after a worker ended while it was written", async ({
  app,
  page,
}) => {
  await endWorker(page, "summarize", 4);
  await app.openStartPage();
  await app.drop(sample("curved-walk"), sample("bowling"), sample("frog-jumps"));
  await expect(page.getByText(/^All processed/)).toBeVisible();
  await page.getByRole("button", { name: /^Save all/ }).click();
  await expect(app.alert).toContainText("labels.zip could not be saved");
  const saved = await app.download(() =>
    app.alert.getByRole("button", { name: "Try again" }).click(),
  );
  const labels = ["curved-walk", "bowling", "frog-jumps"].map((name) => `${name}.plants.json`);
  expect(Object.keys(unzipSync(saved.bytes))).toEqual(expect.arrayContaining(labels));
  // Each name is twice in an archive: with the file, and in the list of files.
  for (const name of labels) expect(saved.text.split(name)).toHaveLength(3);
});
