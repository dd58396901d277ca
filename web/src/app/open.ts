import { batch } from "@preact/signals";
import { nameOfUrl, parseHash } from "../lib/hash";
import { isLabels } from "../lib/labels";
import { bytes } from "../lib/time";
import { clampView } from "../lib/timeView";
import type { Clip } from "../worker/types";
import { compareWith, dropComparison, dropOtherSegments } from "./compare";
import { detectNow } from "./detect";
import { startEdits } from "./edit";
import { engine } from "./engine";
import { fail, messageOf, refuse } from "./failing";
import { fetchBlob } from "./fetch";
import { recall } from "./keep";
import { pause, play, prefersStill } from "./playback";
import { heroSample, samples } from "./samples";
import { segmentNow } from "./segment";
import type { Refusal, Source } from "./state";
import * as state from "./state";

/** Larger files are refused before a byte is read: a worker's memory ends at a few times that. */
export const sizeLimit = 2 ** 30;

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
  engine.cancel();
  state.task.value = null;
}

/** Opens files of a drop, the clip before the labels that belong beside it. */
export async function openFiles(files: readonly File[]): Promise<void> {
  const sources = files.map((file): Source => ({ name: file.name, data: file }));
  const clips = sources.filter((source) => !isLabels(source.name));
  const labels = sources.filter((source) => isLabels(source.name));
  if (clips.length && !(await openFirst(clips))) return;
  for (const source of labels) await compareWith(source.name, source.data);
}

/** Opens the first clip that can be read; the others wait in a list. */
async function openFirst(clips: readonly Source[]): Promise<boolean> {
  refuse([]);
  const refusals: Refusal[] = [];
  for (const source of clips) {
    const opened = await openSource(source);
    if (opened) {
      state.dropped.value = clips.length > 1 ? clips : [];
      refuse(refusals);
      address("");
      return true;
    }
    // Cancelled, or another opening came between.
    if (!state.failure.value) return false;
    refusals.push(state.failure.value);
  }
  if (refusals.length > 1) refuse(refusals);
  return false;
}

export async function openSource(
  source: Source,
  { lenient = false }: { lenient?: boolean } = {},
): Promise<boolean> {
  if (source.data.size > sizeLimit) {
    const failure = {
      message: `The file has ${bytes(source.data.size)}; the limit is 1 GiB.`,
      hint: "Split the clip, or leave out joints nobody needs, and export it again.",
    };
    fail(source.name, failure, source);
    return false;
  }
  const { mine, signal } = begin(source.name, "read");
  // The worker would come to it only after all that it still does for the clip before.
  for (const { stop } of state.work.value) stop();
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
    present(opened.clip, source, false);
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

/** Puts a clip on show from its first frame. */
function present(clip: Clip, source: Source, asHero: boolean) {
  batch(() => {
    pause();
    state.hero.value = asHero;
    state.source.value = source;
    state.overrides.value = {};
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
    dropComparison();
    dropOtherSegments();
    // What was refused before and opens now is no longer refused.
    state.refused.value = state.refused.value.filter((refusal) => refusal.source !== source);
    if (state.looped.value) state.loop.value = "clip";
    state.loopRegion.value = null;
    state.playhead.value = 0;
    state.timeView.value = clampView({ start: 0, end: clip.frames }, clip.frames);
    state.clip.value = clip;
  });
  if (!prefersStill()) play();
}

async function openRemote(
  url: string,
  name: string,
  stage: state.Task["stage"],
  more: Pick<Source, "truth"> = {},
): Promise<boolean> {
  const { mine, signal } = begin(name, stage);
  try {
    const data = await fetchBlob(url, signal, sizeLimit, (share) => {
      if (mine !== turn) return;
      state.task.value = share === undefined ? { name, stage } : { name, stage, share };
    });
    if (mine !== turn) return false;
    state.dropped.value = [];
    return await openSource({ name, data, ...more });
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

export const openUrl = (url: string) => openRemote(url, nameOfUrl(url), "fetch");

export async function openSample(name: string): Promise<boolean> {
  const sample = samples.find((s) => s.name === name);
  if (sample) {
    const { truth } = sample;
    const more = truth ? { truth } : {};
    const opened = await openRemote(sample.url, `${sample.name}.bvh`, "read", more);
    if (opened) address(`#sample=${encodeURIComponent(name)}`);
    return opened;
  }
  fail(name, { message: `There is no sample called "${name}".`, hint: "Choose one below." });
  return false;
}

/** What is open stands in the address, so that it can be passed on and comes back on reload. */
function address(hash: string) {
  history.replaceState(null, "", hash || location.pathname + location.search);
}

/** Follows `#url=` or `#sample=`; otherwise lets a sample move behind the empty page. */
export async function openFromAddress(): Promise<void> {
  const link = parseHash(location.hash);
  if (link?.kind === "url" && (await openUrl(link.url))) return;
  if (link?.kind === "sample" && (await openSample(link.name))) return;
  if (!state.clip.value) await showHero();
}

async function showHero(): Promise<void> {
  if (!heroSample) return;
  const mine = turn;
  try {
    const data = await (await fetch(heroSample.url)).blob();
    const source = { name: `${heroSample.name}.bvh`, data };
    if (mine !== turn) return;
    const opened = await engine.open(data, source.name);
    if (mine !== turn || !opened.ok) return;
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
