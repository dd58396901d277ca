/** The built app as a person meets it: how soon things appear, and whether it ever stutters. */

import { join } from "node:path";
import { root, step } from "../run.mjs";
import { FOLDER, files, HOUR, path, TEN_MEGABYTES } from "./clips.mjs";

/** Opening a clip is measured so many times, each in a page of its own. */
const RUNS = 3;

/** @param {() => Promise<import("playwright").Browser>} launch */
export async function app(launch) {
  step("Measuring the app");
  const { preview } = await import("vite");
  const site = await preview({ root: join(root, "web"), logLevel: "warn" });
  /** Runs some work with the empty page, and watches its main thread meanwhile. */
  const alone = async (work) => {
    const engine = await launch();
    try {
      // Without a graphics card, a figure that moves by itself would take the processors' time.
      const viewport = { width: 1440, height: 900 };
      const page = await engine.newPage({ viewport, reducedMotion: "reduce" });
      page.setDefaultTimeout(120_000);
      await page.addInitScript(() => localStorage.setItem("plantigrade:tour", "done"));
      await page.goto(site.resolvedUrls.local[0], { waitUntil: "networkidle" });
      // A file is dropped with a pointer: the page is ready for somebody by then.
      await page.mouse.move(2, 2);
      await page.locator(".stage canvas").waitFor();
      await page.waitForLoadState("networkidle");
      return await work(page, (during) => watched(engine, page, during));
    } finally {
      await engine.close();
    }
  };
  try {
    const drops = [];
    const hours = [];
    for (let run = 0; run < RUNS; run++) {
      drops.push(await alone((page) => opened(page, path(TEN_MEGABYTES))));
      hours.push(await alone(hour));
    }
    const middle = (values) => values.sort((a, b) => a - b)[Math.floor(RUNS / 2)];
    return {
      drop: {
        moving: middle(drops.map(({ moving }) => moving)),
        labelled: middle(drops.map(({ labelled }) => labelled)),
      },
      hour: {
        moving: middle(hours.map(({ times }) => times.moving)),
        labelled: middle(hours.map(({ times }) => times.labelled)),
        opening: judged(hours.map(({ opening }) => opening)),
        scrubbing: judged(hours.map(({ scrubbing }) => scrubbing)),
        playing: judged(hours.map(({ playing }) => playing)),
      },
      six: judged([await alone(six)]),
      folder: await alone(folder),
    };
  } finally {
    await site.close();
  }
}

/** Milliseconds from the moment the page is given a file to its first pose and to its labels. */
async function opened(page, file) {
  // Timed in the page: handing the file over takes the browser's driver longer than the app.
  const appeared = page.evaluate(
    () =>
      new Promise((resolve) => {
        let start;
        let moving;
        const begin = () => {
          start = performance.now();
        };
        addEventListener("change", begin, { capture: true, once: true });
        const look = () => {
          if (start && !moving && document.querySelector("[data-clip=open]")) {
            // The frame after the next shows what the page has been told by now.
            requestAnimationFrame(() =>
              requestAnimationFrame(() => {
                moving = performance.now() - start;
                look();
              }),
            );
          }
          if (moving && document.querySelector(".pills")) {
            resolve({ moving, labelled: Math.max(moving, performance.now() - start) });
          }
        };
        new MutationObserver(look).observe(document, {
          childList: true,
          attributes: true,
          subtree: true,
        });
      }),
  );
  await page.setInputFiles("input[type=file]", file);
  return await appeared;
}

/** An hour is opened, looked through and played. */
async function hour(page, watch) {
  let times;
  const opening = await watch(async () => {
    times = await opened(page, path(HOUR));
  });
  const box = await page.locator(".tracks canvas, canvas.tracks").first().boundingBox();
  const scrubbing = await watch(async () => {
    const y = box.y + 8;
    await page.mouse.move(box.x + 20, y);
    await page.mouse.down();
    for (let step = 0; step < 120; step++) {
      await page.mouse.move(box.x + 20 + ((box.width - 40) * step) / 120, y);
      await frame(page);
    }
    await page.mouse.up();
  });
  const playing = await watch(async () => {
    await page.keyboard.press("Space");
    await page.waitForTimeout(3000);
    await page.keyboard.press("Space");
  });
  return { times, opening, scrubbing, playing };
}

/** Six characters side by side. */
async function six(page, watch) {
  const chosen = files().slice(0, 6);
  await page.setInputFiles("input[type=file]", chosen);
  await page.getByText(/^All labelled/).waitFor();
  const name = (file) => file.split(/[\\/]/).at(-1);
  const [first, ...others] = chosen.map(name);
  await page.getByRole("button", { name: first, exact: true }).click();
  await page.getByRole("button", { name: "6 clips" }).click();
  for (const other of others) {
    await page.getByRole("button", { name: `${other} beside ${first}`, exact: true }).click();
  }
  await page.getByRole("button", { name: `Back to ${first}` }).click();
  return await watch(async () => {
    await page.keyboard.press("Space");
    await page.waitForTimeout(4000);
  });
}

/** A folder is labelled. */
async function folder(page, watch) {
  let time;
  const seen = await watch(async () => {
    const labelled = page.evaluate(
      (clips) =>
        new Promise((resolve) => {
          let start;
          const begin = () => {
            start = performance.now();
          };
          addEventListener("change", begin, { capture: true, once: true });
          new MutationObserver(() => {
            const text = document.body.textContent;
            if (start && text.includes("All labelled") && text.includes(`${clips} clips`)) {
              resolve(performance.now() - start);
            }
          }).observe(document.body, { childList: true, characterData: true, subtree: true });
        }),
      FOLDER.clips,
    );
    await page.setInputFiles("input[type=file]", files());
    time = await labelled;
  });
  return { time, ...judged([seen]) };
}

const frame = (page) => page.evaluate(() => new Promise(requestAnimationFrame));

const CATEGORIES = ["devtools.timeline", "disabled-by-default-devtools.timeline"];
/** What is the page's own script, in the browser's words. */
const SCRIPT = new Set([
  "FunctionCall",
  "FireAnimationFrame",
  "EventDispatch",
  "TimerFire",
  "EvaluateScript",
]);

/** Microseconds of a frame. */
const FRAME = 1e6 / 60;

/**
 * What the page's main thread does during some work: milliseconds of its own script in each frame
 * in which there is any, and its longest task. Both are of the processor's time: a browser without
 * a graphics card draws on the same processors.
 */
async function watched(engine, page, work) {
  await engine.startTracing(page, { categories: CATEGORIES });
  await work();
  const { traceEvents } = JSON.parse((await engine.stopTracing()).toString());
  const main = busiest(traceEvents, "FireAnimationFrame");
  const own = traceEvents
    .filter(({ ph, pid, tid }) => ph === "X" && `${pid} ${tid}` === main)
    .sort((a, b) => a.ts - b.ts || b.dur - a.dur);
  const script = new Map();
  let until = 0;
  for (const { name, ts, dur = 0, tdur = dur } of own) {
    // What runs inside of another is counted with it.
    if (!SCRIPT.has(name) || ts < until) continue;
    until = ts + dur;
    const frame = Math.floor(ts / FRAME);
    script.set(frame, (script.get(frame) ?? 0) + tdur / 1e3);
  }
  const tasks = own
    .filter(({ name }) => name === "RunTask")
    .map(({ dur, tdur = dur }) => tdur / 1e3);
  return {
    frames: [...script.values()],
    longest: tasks.reduce((a, b) => Math.max(a, b), 0),
  };
}

/** The 95th percentile of script per frame and the longest task, of all times the same was done. */
function judged(seen) {
  const frames = seen.flatMap(({ frames }) => frames).sort((a, b) => a - b);
  return {
    script: frames[Math.floor(frames.length * 0.95)] ?? 0,
    longest: Math.max(...seen.map(({ longest }) => longest)),
    frames: frames.length,
  };
}

/** The thread with most events of this name. */
function busiest(events, wanted) {
  const counts = new Map();
  for (const { name, pid, tid } of events) {
    if (name !== wanted) continue;
    const thread = `${pid} ${tid}`;
    counts.set(thread, (counts.get(thread) ?? 0) + 1);
  }
  return [...counts].sort((a, b) => b[1] - a[1])[0]?.[0];
}
