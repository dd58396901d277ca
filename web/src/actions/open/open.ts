/** Opening one clip: a file, a sample or a download. */

import { batch } from "@preact/signals";
import { engine } from "../../engine";
import { failureOf } from "../../model/failure";
import { fileTooLarge, maxFileBytes } from "../../model/limits";
import { fileNameOfUrl, formatHash } from "../../model/sources/link";
import { type Source, titleOfSource } from "../../model/sources/source";
import type { Clip, Failure } from "../../model/types";
import { ClipSession, openSession, session } from "../../store/clip-session";
import { isFramed } from "../../store/embedded";
import { errorReport, reportOpenFailure } from "../../store/errors";
import { type Opening, opening, stopClipJobs } from "../../store/jobs";
import { segmentOptions } from "../../store/settings";
import { showToast } from "../../store/toasts";
import { dialog, message } from "../../store/view";
import { plural } from "../../util/format";
import { runDetection } from "../analyse/detect";
import { runSegmentation } from "../analyse/segment";
import { restorePersisted } from "../stored/persist";
import { pause, play, prefersReducedMotion } from "../view/playback";
import { applyViewState, overridesOf } from "../view/view-state";
import { fetchBlob } from "./fetch-blob";
import { addHistoryEntry } from "./history";
import { samples } from "./samples";

/** Aborted when another clip is opened or the opening is cancelled. */
let controller = new AbortController();

/** Returns a signal that aborts when a clip is opened from now on. */
export const openingSignal = () => controller.signal;

/** Shows that a clip is opened instead of the previous one. Returns a signal that aborts when another one is opened. */
export function beginOpening(name: string, stage: Opening["stage"]): AbortSignal {
  controller.abort();
  controller = new AbortController();
  batch(() => {
    errorReport.value = null;
    dialog.value = null;
    opening.value = { name, stage };
  });
  return controller.signal;
}

/** Cancels the opening; the previous clip remains open. */
export function cancelOpening() {
  controller.abort();
  controller = new AbortController();
  stopClipJobs();
  opening.value = null;
}

/** Ends the opening, and reports why the clip could not be opened. */
function endOpening(...failure: Parameters<typeof reportOpenFailure>) {
  batch(() => {
    opening.value = null;
    reportOpenFailure(...failure);
  });
}

/** Called when a clip is the open one, also if that took another attempt. */
type WhenOpen = (() => unknown) | undefined;

interface OpenOptions {
  /** By default, as when the clip was open before, or as its link says. */
  lenient?: boolean;
  whenOpen?: WhenOpen;
}

/** Opens a clip and labels it. Returns true if it is the open one at the end. */
export async function openSource(
  source: Source,
  { lenient = source.lenient ?? source.view?.lenient === "yes", whenOpen }: OpenOptions = {},
): Promise<boolean> {
  const { name, data } = source;
  const title = titleOfSource(source);
  const openAgain = (lenient: boolean) => () => void openSource(source, { lenient, whenOpen });
  const retry = openAgain(lenient);
  const signal = beginOpening(title, "read");
  if (data.size > maxFileBytes) {
    endOpening(title, fileTooLarge(data.size));
    return false;
  }
  // The worker would otherwise finish the pending calls first.
  stopClipJobs();
  try {
    // Edits of the previous clip that are not in its labels yet would be lost.
    await Promise.race([session.value.editsDone(), rejectOnAbort(signal)]);
    const onProgress = (fraction: number) => {
      if (!signal.aborted) opening.value = { name: title, stage: "read", fraction };
    };
    const overrides = overridesOf(source.view ?? {});
    const changes = Object.keys(overrides).length ? { overrides } : {};
    const opened = await Promise.race([
      engine.open(data, name, { lenient, ...changes, signal, onProgress }),
      rejectOnAbort(signal),
    ]);
    if (signal.aborted) return false;
    if (!opened.ok) {
      endOpening(title, opened.failure, { openLeniently: openAgain(true), retry });
      return false;
    }
    source.lenient = lenient;
    if (opened.rejected) reportRejected(opened.rejected, source);
    showClip(opened.clip, source);
    opening.value = { name: title, stage: "detect" };
    await Promise.race([runDetection(), rejectOnAbort(signal)]);
    if (!signal.aborted) {
      // Requested before the segmentation, so that edits are shown first.
      const restored = restorePersisted();
      const segmented = runSegmentation();
      opening.value = null;
      await Promise.all([restored, segmented]);
    }
    const isOpen = source === session.value.source;
    if (isOpen) await whenOpen?.();
    return isOpen;
  } catch (error) {
    if (!signal.aborted) endOpening(title, failureOf(error), { retry });
    return false;
  }
}

/** Reports that the overrides of a link or a shared page were not applied, and forgets them. */
function reportRejected({ message }: Failure, source: Source) {
  showToast({ text: `The link changes how the file is read, but ${message}.` });
  const { rate: _1, up: _2, unit: _3, joints: _4, ...others } = source.view ?? {};
  source.view = others;
}

/** Makes a clip the open one, at its first frame or at the moment of its view state. */
export function showClip(clip: Clip, source: Source, isPreview = false) {
  const { view } = source;
  const loop = session.value.loop.value;
  batch(() => {
    pause();
    // It is about the clip before.
    message.value = "";
    reportLostEdits(session.value);
    forgetTemplateFrame();
    if (view) applyViewState(view);
    openSession(
      new ClipSession(clip, source, {
        isPreview,
        overrides: view ? overridesOf(view) : {},
        playhead: Math.round((view?.t ?? 0) * clip.rate),
        loop: loop === "off" ? "off" : "clip",
      }),
    );
  });
  // A shared moment is shown as it is. A document may have many frames with clips.
  if (!prefersReducedMotion() && !view?.t && !isFramed) play();
}

/** Reports the edits that the user made while the next clip was read. */
function reportLostEdits({ pendingEdits, source }: ClipSession) {
  if (!pendingEdits || !source) return;
  const edits = plural(pendingEdits, "edit");
  showToast({
    text: `${edits} of ${titleOfSource(source)} came too late: another clip was being opened.`,
  });
}

/** Resets a segmentation template that is a frame of the previous clip. */
function forgetTemplateFrame() {
  if (!Number.isInteger(Number(segmentOptions.value.template))) return;
  const { template: _, ...rest } = segmentOptions.value;
  segmentOptions.value = rest;
}

async function openRemote(
  url: string,
  name: string,
  stage: Opening["stage"],
  more: Partial<Source> = {},
  whenOpen?: WhenOpen,
): Promise<boolean> {
  const signal = beginOpening(name, stage);
  try {
    const data = await fetchBlob(url, signal, maxFileBytes, (fraction) => {
      if (signal.aborted) return;
      opening.value = fraction === undefined ? { name, stage } : { name, stage, fraction };
    });
    if (signal.aborted) return false;
    return await openSource({ ...more, name, data }, { whenOpen });
  } catch (error) {
    if (!signal.aborted) {
      const failure = {
        hint: "Download the file and drop it here instead.",
        canRetry: error instanceof Error,
        ...failureOf(error),
      };
      const retry = () => void openRemote(url, name, stage, more, whenOpen);
      endOpening(name, failure, { retry });
    }
    return false;
  }
}

export const openUrl = (url: string, more: Partial<Source> = {}) =>
  openRemote(url, fileNameOfUrl(url), "fetch", { ...more, origin: { kind: "url", url } });

export async function openSample(name: string, more: Partial<Source> = {}): Promise<boolean> {
  const sample = samples.find((other) => other.name === name);
  if (sample) {
    const { truthUrl } = sample;
    const origin = { kind: "sample", name } as const;
    const source = { ...more, ...(truthUrl ? { truthUrl } : {}), origin };
    return openRemote(sample.url, `${sample.name}.bvh`, "read", source, () => {
      // The address of a followed link does not change.
      if (!more.view) addHistoryEntry(formatHash({ origin, view: "" }));
    });
  }
  endOpening(name, {
    message: `There is no sample called "${name}".`,
    hint: "Choose one of the samples on the start page.",
  });
  return false;
}

function rejectOnAbort(signal: AbortSignal): Promise<never> {
  return new Promise((_, reject) => {
    signal.addEventListener("abort", () => reject(new Error("cancelled")), { once: true });
  });
}
