/** Benchmarks of the built app: response times and the load of the main thread. */

import { readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { root, run, step } from "../run.mjs";
import {
  batchFiles,
  batchFolder,
  benchFolder,
  FOLDER,
  filePath,
  HOUR,
  TEN_MEGABYTES,
} from "./clips.mjs";
import { alternate, timeRow } from "./pairs.mjs";
import { serveSlowly } from "./slow-server.mjs";

/** Number of recordings of an hour and of six characters, each in a new page: the fewest with an interval. */
const RECORDINGS = 6;
/** Duration of a frame of the display, in milliseconds. */
const FRAME = 1000 / 60;

/**
 * Returns rows on the built app.
 * @param {{ launch: () => Promise<import("playwright").Browser>, native: object, server: object }} options
 */
export async function appRows({ launch, native, server }) {
  step("Measuring the app");
  const { preview } = await import("vite");
  const site = await preview({ root: join(root, "web"), logLevel: "warn", preview: { port: 0 } });
  const address = site.resolvedUrls.local[0];
  /** Runs a measurement on the start page of a newly started browser. */
  const inNewPage = (measure) =>
    inNewBrowser(launch, async (page, browser) => {
      await page.goto(address, { waitUntil: "networkidle" });
      // Loads everything that waits for the first interaction, as before a real drop.
      await page.mouse.move(2, 2);
      await page.locator(".stage canvas").waitFor();
      await page.waitForLoadState("networkidle");
      return await measure(page, (during) => recordMainThread(browser, page, during));
    });
  const benchPage = await server.open();
  try {
    await benchPage.open(TEN_MEGABYTES);
    const alone = async () =>
      (await benchPage.measure("read-file")) + (await benchPage.measure("detect"));
    const firstPoses = [];
    const drops = await alternate(
      7,
      async () => {
        const drop = (page) => measureOpening(page, filePath(TEN_MEGABYTES));
        const { firstPose, labels } = await inNewPage(drop);
        firstPoses.push({ ours: firstPose, reference: await alone() });
        return labels;
      },
      alone,
    );
    // The table of the page has plants and segments of each clip.
    const commandLine = async () => {
      const start = performance.now();
      for (const command of ["detect", "segment"]) {
        const output = ["--force", "--out", join(benchFolder, command)];
        await run(native.commandLine, [command, batchFolder, ...output], { quiet: true });
      }
      return performance.now() - start;
    };
    const folderLoads = [];
    const folders = await alternate(
      3,
      async () => {
        const { time, recording } = await inNewPage(measureFolder);
        folderLoads.push(recording);
        return time;
      },
      commandLine,
    );
    const hours = [];
    const hourLabels = [];
    await benchPage.open(HOUR);
    for (let run = 0; run < RECORDINGS; run++) {
      hours.push(await inNewPage(measureHour));
      hourLabels.push({ ours: hours.at(-1).times.labels, reference: await alone() });
    }
    const sixes = [];
    for (let run = 0; run < RECORDINGS; run++) sixes.push(await inNewPage(measureSix));
    const loads = {
      "opening one hour": hours.map(({ opening }) => opening),
      "scrubbing through one hour": hours.map(({ scrubbing }) => scrubbing),
      "playing one hour": hours.map(({ playing }) => playing),
      "playing six characters": sixes,
      "processing the folder": folderLoads,
    };
    return [
      timeRow("drop 10 MB → labels", "reading and labelling alone", drops, 1.5),
      timeRow("drop 10 MB → moving skeleton", "reading and labelling alone", firstPoses),
      timeRow("drop one hour → labels", "reading and labelling alone", hourLabels),
      timeRow(
        `folder of ${FOLDER.clips} clips in the page`,
        "`detect` and `segment` of the command line, two threads",
        folders,
        2,
      ),
      timeRow(
        "first labels from a link over a slow network",
        "loading all files of the site",
        await firstVisits(launch),
        0.67,
      ),
      ...Object.entries(loads).flatMap(([activity, recordings]) => loadRows(activity, recordings)),
    ];
  } finally {
    await benchPage.close();
    await site.close();
  }
}

/** Runs a measurement in an empty page of a newly started browser. */
async function inNewBrowser(launch, measure) {
  const browser = await launch();
  try {
    // With software rendering, the animated preview would take processor time.
    const viewport = { width: 1440, height: 900 };
    const page = await browser.newPage({ viewport, reducedMotion: "reduce" });
    page.setDefaultTimeout(180_000);
    await page.addInitScript(() => localStorage.setItem("plantigrade:tour", "done"));
    return await measure(page, browser);
  } finally {
    await browser.close();
  }
}

/**
 * Returns pairs of the time from a link to the first labels, and the time that the network needs for all
 * scripts, styles and modules of the site, which a page loaded before it was split.
 */
async function firstVisits(launch) {
  const files = siteFiles();
  const server = await serveSlowly(join(root, "web/dist"));
  const visit = async (page) => {
    const start = performance.now();
    await page.goto(`${server.address}#sample=curved-walk`, { waitUntil: "commit" });
    await page.locator(".pills").first().waitFor();
    return performance.now() - start;
  };
  const loadAll = async (page) => {
    // Any page of the server without a content security policy of its own.
    await page.goto(`${server.address}nothing`);
    return await page.evaluate(async (files) => {
      const start = performance.now();
      await Promise.all(files.map(async (file) => (await fetch(file)).arrayBuffer()));
      return performance.now() - start;
    }, files);
  };
  try {
    return await alternate(
      5,
      ...[visit, loadAll].map((measure) => () => inNewBrowser(launch, measure)),
    );
  } finally {
    await server.close();
  }
}

/** Returns the paths of the scripts, styles, fonts and modules of the site. */
const siteFiles = () =>
  readdirSync(join(root, "web/dist/assets"))
    .filter((name) => /\.(js|css|wasm)$/.test(name))
    .map((name) => `assets/${name}`);

/** Returns rows on the script time per frame and the longest task, relative to a frame of the display. */
function loadRows(activity, recordings) {
  const percentile = ({ frames }) =>
    frames.toSorted((a, b) => a - b)[Math.floor(frames.length * 0.95)] ?? 0;
  const row = (what, value, target) => {
    const pairs = recordings.map((recording) => ({ ours: value(recording), reference: FRAME }));
    return timeRow(`${activity}: ${what}`, "a frame of the display", pairs, target);
  };
  return [
    row("script per frame (95th percentile)", percentile, 8 / FRAME),
    row("longest task", ({ longest }) => longest, 50 / FRAME),
  ];
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
  // Otherwise the clip would replace the table when it is open.
  await page.locator("[data-clip=open]").waitFor();
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
  return { time, recording };
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
