import { batch } from "@preact/signals";
import { type Link, nameOfUrl, parseHash, writeHash } from "../lib/hash";
import { clampView } from "../lib/timeView";
import type { Clip } from "../worker/types";
import { survey, tableShown } from "./batch";
import { compareWith, dropComparison, dropOtherSegments } from "./compare";
import { detectNow } from "./detect";
import { startEdits } from "./edit";
import { type Enclosed, enclosed, enclosedSource } from "./enclosed";
import { engine } from "./engine";
import { fail, messageOf } from "./failing";
import { fetchBlob } from "./fetch";
import { type Files, gather, withLabels } from "./gather";
import { recall } from "./keep";
import { sizeLimit, tooLarge } from "./limits";
import { pause, play, prefersStill } from "./playback";
import { somebody } from "./presence";
import { remark } from "./remarks";
import { heroSample, samples } from "./samples";
import { segmentNow } from "./segment";
import { ask, overridesOf, understand } from "./showing";
import type { Source } from "./state";
import * as state from "./state";

/** Tells a stale opening from the one a person waits for. */
let turn = 0;
let controller = new AbortController();

function begin(name: string, stage: state.Task["stage"]): { mine: number; signal: AbortSignal } {
  controller.abort();
  controller = new AbortController();
  batch(() => {
    state.failure.value = null;
    state.dialog.value = null;
    state.task.value = { name, stage };
  });
  return { mine: ++turn, signal: controller.signal };
}

/** Stops what is being opened; the clip before it stays. */
export function cancelOpening() {
  turn++;
  controller.abort();
  stopWork();
  engine.cancel();
  state.task.value = null;
}

/** Stops what is being done for the clip on show. */
function stopWork() {
  for (const { name, stop } of state.work.value) if (name === undefined) stop();
}

let drops = 0;

/** Opens what was dropped: one clip with the labels that belong beside it, or many in a table. */
export async function openFiles(dropped: Files): Promise<void> {
  const mine = ++drops;
  const gathered = await gather(dropped);
  // Whoever has dropped something else meanwhile wants that.
  if (mine !== drops || !gathered) return;
  const { clips, labels, refusals } = gathered;
  const [only, ...others] = clips;
  if (others.length || (refusals.length && only) || refusals.length > 1) {
    const matched = withLabels(clips, labels);
    await survey(matched.clips, [...refusals, ...matched.refusals]);
    return;
  }
  const [refused] = refusals;
  if (refused) fail(refused.name, refused.failure);
  if (only && !(await openSource(only))) return;
  if (only) tableShown.value = false;
  if (only) address("");
  for (const source of labels) await compareWith(source.name, source.data);
}

export async function openSource(
  source: Source,
  { lenient = source.showing?.lenient === "yes" }: { lenient?: boolean } = {},
): Promise<boolean> {
  if (source.data.size > sizeLimit) {
    fail(source.name, tooLarge(source.data.size), source);
    return false;
  }
  const { mine, signal } = begin(source.name, "read");
  // The worker would come to it only after all that it still does for the clip before.
  stopWork();
  try {
    const opened = await Promise.race([
      engine.open(source.data, source.name, {
        lenient,
        onProgress(share) {
          if (mine === turn) state.task.value = { name: source.name, stage: "read", share };
        },
      }),
      aborted(signal),
    ]);
    if (mine !== turn) return false;
    if (!opened.ok) {
      fail(source.name, opened.failure, source);
      return false;
    }
    source.lenient = lenient;
    const clip = await reread(opened.clip, source);
    if (mine !== turn) return false;
    present(clip, source, false);
    state.task.value = { name: source.name, stage: "detect" };
    await Promise.race([detectNow(), aborted(signal)]);
    if (mine !== turn) return true;
    // Asked for first: what a person did is on show before the segments are.
    const recalled = recall();
    const segmented = segmentNow();
    state.task.value = null;
    await Promise.all([recalled, segmented]);
    return true;
  } catch (error) {
    if (mine === turn) fail(source.name, { message: messageOf(error) }, source);
    return false;
  }
}

/** Reads a clip as whoever passed it on had it read. */
async function reread(clip: Clip, source: Source): Promise<Clip> {
  const overrides = overridesOf(source.showing ?? {});
  if (!Object.keys(overrides).length) return clip;
  const opened = await engine.override(overrides);
  if (opened.ok) return opened.clip;
  remark({ text: `The link says how to read the file, but ${opened.failure.message}.` });
  const { rate: _1, up: _2, unit: _3, joints: _4, ...others } = source.showing ?? {};
  source.showing = others;
  return clip;
}

/** Puts a clip on show from its first frame, or from the moment it is passed on at. */
function present(clip: Clip, source: Source, asHero: boolean) {
  const { showing } = source;
  batch(() => {
    pause();
    state.hero.value = asHero;
    state.source.value = source;
    state.overrides.value = showing ? overridesOf(showing) : {};
    state.detection.value = null;
    state.detectFailure.value = null;
    state.segmentation.value = null;
    state.segmentFailure.value = null;
    state.segmentNames.value = [];
    void startEdits([]);
    // A frame of another clip is no template.
    if (Number.isInteger(Number(state.segmentOptions.value.template))) {
      const { template: _, ...rest } = state.segmentOptions.value;
      state.segmentOptions.value = rest;
    }
    if (showing) ask(showing);
    dropComparison();
    dropOtherSegments();
    if (state.looped.value) state.loop.value = "clip";
    state.loopRegion.value = null;
    state.playhead.value = Math.min(
      Math.round((showing?.t ?? 0) * clip.rate),
      Math.max(0, clip.frames - 1),
    );
    state.timeView.value = clampView({ start: 0, end: clip.frames }, clip.frames);
    state.clip.value = clip;
  });
  // Whoever was sent a moment wants to see it.
  if (!prefersStill() && !showing?.t) play();
}

async function openRemote(
  url: string,
  name: string,
  stage: state.Task["stage"],
  more: Partial<Source> = {},
): Promise<boolean> {
  const { mine, signal } = begin(name, stage);
  try {
    const data = await fetchBlob(url, signal, sizeLimit, (share) => {
      if (mine !== turn) return;
      state.task.value = share === undefined ? { name, stage } : { name, stage, share };
    });
    if (mine !== turn) return false;
    return await openSource({ ...more, name, data });
  } catch (error) {
    if (mine === turn) {
      fail(name, {
        message: messageOf(error),
        hint: "Download the file and drop it here instead.",
      });
    }
    return false;
  }
}

export const openUrl = (url: string, more: Partial<Source> = {}) =>
  openRemote(url, nameOfUrl(url), "fetch", { ...more, origin: { kind: "url", url } });

export async function openSample(name: string, more: Partial<Source> = {}): Promise<boolean> {
  const sample = samples.find((s) => s.name === name);
  if (sample) {
    const { truth } = sample;
    const origin = { kind: "sample", name } as const;
    const opened = await openRemote(sample.url, `${sample.name}.bvh`, "read", {
      ...more,
      ...(truth ? { truth } : {}),
      origin,
    });
    // A link that was followed stays as it is.
    if (opened && !more.showing) address(writeHash({ origin, showing: "" }));
    return opened;
  }
  fail(name, { message: `There is no sample called "${name}".`, hint: "Choose one below." });
  return false;
}

/** What is open stands in the address, so that it can be passed on and comes back on reload. */
function address(hash: string) {
  history.replaceState(null, "", hash || location.pathname + location.search);
}

/**
 * Opens what a shared page holds, or follows `#url=` or `#sample=`; otherwise lets a sample move
 * behind the empty page.
 */
export async function openFromAddress(): Promise<void> {
  if (enclosed) {
    if (!state.clip.value) await openEnclosed(enclosed);
    return;
  }
  const link = parseHash(location.hash);
  if (link && (await follow(link))) return;
  if (!state.clip.value) await showHero();
}

async function openEnclosed(held: Enclosed): Promise<void> {
  try {
    const showing = await understand(held.showing);
    await openSource({ ...(await enclosedSource(held)), showing });
  } catch (error) {
    fail(held.name, { message: messageOf(error), hint: "Ask for the page again." });
  }
}

async function follow({ origin, showing: text }: Link): Promise<boolean> {
  const before = turn;
  const showing = await understand(text);
  // Whoever has opened something else meanwhile wants that.
  if (before !== turn) return true;
  return origin.kind === "url"
    ? openUrl(origin.url, { showing })
    : openSample(origin.name, { showing });
}

async function showHero(): Promise<void> {
  if (!heroSample) return;
  const mine = turn;
  // Behind a table it would only take time from those who fill it.
  const isUnwanted = () => mine !== turn || tableShown.value;
  await somebody;
  if (isUnwanted()) return;
  try {
    const data = await (await fetch(heroSample.url)).blob();
    const source = { name: `${heroSample.name}.bvh`, data };
    if (isUnwanted()) return;
    const opened = await engine.open(data, source.name);
    if (isUnwanted() || !opened.ok) return;
    present(opened.clip, source, true);
    await detectNow();
  } catch {
    // Only a picture: the page is whole without it.
  }
}

function aborted(signal: AbortSignal): Promise<never> {
  return new Promise((_, reject) => {
    signal.addEventListener("abort", () => reject(new Error("cancelled")), { once: true });
  });
}
