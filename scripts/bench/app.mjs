/** Benchmarks of the built app: response times and the load of the main thread. */

import { basename, join } from "node:path";
import { root, step } from "../run.mjs";
import { batchFiles, FOLDER, filePath, HOUR, TEN_MEGABYTES } from "./clips.mjs";

/** Number of measurements of opening a clip, each in a new page. */
const RUNS = 3;

/** @param {() => Promise<import("playwright").Browser>} launch */
export async function measureApp(launch) {
  step("Measuring the app");
  const { preview } = await import("vite");
  const site = await preview({ root: join(root, "web"), logLevel: "warn" });
  /** Runs a measurement on the start page of a newly started browser. */
  const inNewPage = async (measure) => {
    const browser = await launch();
    try {
      // With software rendering, the animated preview would take processor time.
      const viewport = { width: 1440, height: 900 };
      const page = await browser.newPage({ viewport, reducedMotion: "reduce" });
      page.setDefaultTimeout(120_000);
      await page.addInitScript(() => localStorage.setItem("plantigrade:tour", "done"));
      await page.goto(site.resolvedUrls.local[0], { waitUntil: "networkidle" });
      // Loads everything that waits for the first interaction, as before a real drop.
      await page.mouse.move(2, 2);
      await page.locator(".stage canvas").waitFor();
      await page.waitForLoadState("networkidle");
      return await measure(page, (during) => recordMainThread(browser, page, during));
    } finally {
      await browser.close();
    }
  };
  try {
    const drops = [];
    const hours = [];
    for (let run = 0; run < RUNS; run++) {
      drops.push(await inNewPage((page) => measureOpening(page, filePath(TEN_MEGABYTES))));
      hours.push(await inNewPage(measureHour));
    }
    const median = (values) => values.sort((a, b) => a - b)[Math.floor(RUNS / 2)];
    return {
      drop: {
        firstPose: median(drops.map(({ firstPose }) => firstPose)),
        labels: median(drops.map(({ labels }) => labels)),
      },
      hour: {
        firstPose: median(hours.map(({ times }) => times.firstPose)),
        labels: median(hours.map(({ times }) => times.labels)),
        opening: summarize(hours.map(({ opening }) => opening)),
        scrubbing: summarize(hours.map(({ scrubbing }) => scrubbing)),
        playing: summarize(hours.map(({ playing }) => playing)),
      },
      six: summarize([await inNewPage(measureSix)]),
      folder: await inNewPage(measureFolder),
    };
  } finally {
    await site.close();
  }
}

/** Returns the times from receiving a file to the first pose and to the labels, in milliseconds. */
async function measureOpening(page, file) {
  // Timed in the page, since passing the file through the driver takes longer than opening it.
  const times = page.evaluate(
    () =>
      new Promise((resolve) => {
        let start;
        let firstPose;
        const onStart = () => {
          start = performance.now();
        };
        addEventListener("change", onStart, { capture: true, once: true });
        const check = () => {
          if (start && !firstPose && document.querySelector("[data-clip=open]")) {
            // Two frames later the change is on the screen.
            requestAnimationFrame(() =>
              requestAnimationFrame(() => {
                firstPose = performance.now() - start;
                check();
              }),
            );
          }
          if (firstPose && document.querySelector(".pills")) {
            resolve({ firstPose, labels: Math.max(firstPose, performance.now() - start) });
          }
        };
        new MutationObserver(check).observe(document, {
          childList: true,
          attributes: true,
          subtree: true,
        });
      }),
  );
  await page.setInputFiles("input[type=file]", file);
  return await times;
}

/** Measures opening, scrubbing and playing a clip of one hour. */
async function measureHour(page, record) {
  let times;
  const opening = await record(async () => {
    times = await measureOpening(page, filePath(HOUR));
  });
  const box = await page.locator(".tracks canvas").boundingBox();
  const scrubbing = await record(async () => {
    const y = box.y + 8;
    await page.mouse.move(box.x + 20, y);
    await page.mouse.down();
    for (let step = 0; step < 120; step++) {
      await page.mouse.move(box.x + 20 + ((box.width - 40) * step) / 120, y);
      await nextFrame(page);
    }
    await page.mouse.up();
  });
  const playing = await record(async () => {
    await page.keyboard.press("Space");
    await page.waitForTimeout(3000);
    await page.keyboard.press("Space");
  });
  return { times, opening, scrubbing, playing };
}

/** Measures playing six characters side by side. */
async function measureSix(page, record) {
  const paths = batchFiles().slice(0, 6);
  await page.setInputFiles("input[type=file]", paths);
  await page.getByText(/^All processed/).waitFor();
  const [first, ...others] = paths.map((path) => basename(path));
  await page.getByRole("button", { name: first, exact: true }).click();
  await page.getByRole("button", { name: "6 clips" }).click();
  for (const other of others) {
    await page
      .getByRole("button", { name: `${other} side by side with ${first}`, exact: true })
      .click();
  }
  await page.getByRole("button", { name: `Back to ${first}` }).click();
  return await record(async () => {
    await page.keyboard.press("Space");
    await page.waitForTimeout(4000);
  });
}

/** Measures detection in all clips of a folder. */
async function measureFolder(page, record) {
  let time;
  const recording = await record(async () => {
    const finished = page.evaluate(
      (clips) =>
        new Promise((resolve) => {
          let start;
          const onStart = () => {
            start = performance.now();
          };
          addEventListener("change", onStart, { capture: true, once: true });
          new MutationObserver(() => {
            const text = document.body.textContent;
            if (start && text.includes("All processed") && text.includes(`${clips} clips`)) {
              resolve(performance.now() - start);
            }
          }).observe(document.body, { childList: true, characterData: true, subtree: true });
        }),
      FOLDER.clips,
    );
    await page.setInputFiles("input[type=file]", batchFiles());
    time = await finished;
  });
  return { time, ...summarize([recording]) };
}

const nextFrame = (page) => page.evaluate(() => new Promise(requestAnimationFrame));

const CATEGORIES = ["devtools.timeline", "disabled-by-default-devtools.timeline"];
/** Trace events that run scripts of the page. */
const SCRIPT_EVENTS = new Set([
  "FunctionCall",
  "FireAnimationFrame",
  "EventDispatch",
  "TimerFire",
  "EvaluateScript",
]);

/** Duration of a frame, in microseconds. */
const FRAME_DURATION = 1e6 / 60;

/**
 * Records the main thread during a measurement. Returns the script time of each frame with scripts and
 * the longest task, in milliseconds of processor time, since software rendering competes for the same
 * processors.
 */
async function recordMainThread(browser, page, measure) {
  await browser.startTracing(page, { categories: CATEGORIES });
  await measure();
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const mainThread = busiestThread(traceEvents, "FireAnimationFrame");
  const events = traceEvents
    .filter(({ ph, pid, tid }) => ph === "X" && `${pid} ${tid}` === mainThread)
    .sort((a, b) => a.ts - b.ts || b.dur - a.dur);
  /** Script time by frame. */
  const script = new Map();
  let lastEnd = 0;
  for (const { name, ts, dur = 0, tdur = dur } of events) {
    // Nested events are part of the outer event.
    if (!SCRIPT_EVENTS.has(name) || ts < lastEnd) continue;
    lastEnd = ts + dur;
    const frame = Math.floor(ts / FRAME_DURATION);
    script.set(frame, (script.get(frame) ?? 0) + tdur / 1e3);
  }
  const tasks = events
    .filter(({ name }) => name === "RunTask")
    .map(({ dur, tdur = dur }) => tdur / 1e3);
  return {
    frames: [...script.values()],
    longest: tasks.reduce((a, b) => Math.max(a, b), 0),
  };
}

/** Returns the 95th percentile of the script time per frame and the longest task of recordings. */
function summarize(recordings) {
  const frames = recordings.flatMap(({ frames }) => frames).sort((a, b) => a - b);
  return {
    script: frames[Math.floor(frames.length * 0.95)] ?? 0,
    longest: Math.max(...recordings.map(({ longest }) => longest)),
    frames: frames.length,
  };
}

/** Returns the thread with the most events of a name. */
function busiestThread(events, eventName) {
  const counts = new Map();
  for (const { name, pid, tid } of events) {
    if (name !== eventName) continue;
    const thread = `${pid} ${tid}`;
    counts.set(thread, (counts.get(thread) ?? 0) + 1);
  }
  return [...counts].sort((a, b) => b[1] - a[1])[0]?.[0];
}
