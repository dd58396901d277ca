/** Detecting plants, and overriding how the clip is read. */

import { batch } from "@preact/signals";
import { engine } from "../../engine";
import { failureOf } from "../../model/failure";
import type { DetectOptions, Overrides } from "../../model/types";
import { type ClipSession, session } from "../../store/clip-session";
import { reportFailure } from "../../store/errors";
import { createExclusiveJob } from "../../store/jobs";
import { detectMethods, detectOptions, plantFormats } from "../../store/settings";
import { latestOnly } from "../../util/latest-only";
import { followSelection } from "../edit/edit";
import { findSimilar } from "../edit/find-similar";
import { updateScores } from "./compare";
import { runSegmentation, stopSegmenting } from "./segment";

async function listMethodsAndFormats() {
  if (detectMethods.value.length) return;
  const [methods, formats] = await Promise.all([engine.methods(), engine.plantFormats()]);
  batch(() => {
    detectMethods.value = methods;
    plantFormats.value = formats;
  });
}

// The wait is long because a stopped worker has to read the file again.
const job = createExclusiveJob("Detecting plants in", 2000);

/** True while a detection with the current options is running. */
export const detecting = job.busy;

/** Detects the plants of the open clip. */
export async function runDetection(options: DetectOptions = detectOptions.value): Promise<void> {
  const clipSession = session.value;
  if (!clipSession.clip.value) return;
  try {
    const detected = await clipSession.run("detect", () =>
      job.run(
        async (callOptions) => {
          // Requested together, so that the worker need not wait for the page.
          const listed = listMethodsAndFormats();
          const [detected] = await Promise.all([engine.detect(options, callOptions), listed]);
          return detected;
        },
        () => revertOptions(clipSession),
      ),
    );
    if (!detected) return;
    batch(() => {
      clipSession.detection.value = detected.ok ? detected.detection : null;
      clipSession.detectFailure.value = detected.ok ? null : detected.failure;
      followSelection(clipSession);
      // The looped plant may have moved.
      if (clipSession.loop.value === "plant") {
        clipSession.loop.value = "clip";
        clipSession.loopRegion.value = null;
      }
    });
  } catch (error) {
    batch(() => {
      clipSession.detection.value = null;
      clipSession.detectFailure.value = failureOf(error);
    });
    return;
  }
  try {
    await Promise.all([updateScores(clipSession), findSimilar(clipSession)]);
  } catch (error) {
    const name = clipSession.source?.name ?? "";
    // The labels remain valid.
    reportFailure("compared", name, error, () => void runDetection(options));
  }
}

/** After the user stopped a detection, restores the options of the labels that are shown. */
function revertOptions(clipSession: ClipSession) {
  batch(() => {
    const detection = clipSession.detection.value;
    if (detection) detectOptions.value = detection.options;
    else
      clipSession.detectFailure.value = {
        message: "it was cancelled",
        hint: "Change a setting to try again.",
      };
  });
}

const detectLatest = latestOnly(runDetection);

export function setDetectOptions(change: Partial<DetectOptions>) {
  detectOptions.value = { ...detectOptions.value, ...change };
  job.stopIfSlow();
  detectLatest(detectOptions.value);
}

const overrideLatest = latestOnly(async (overrides: Overrides) => {
  const action = "read with these settings";
  const clipSession = session.value;
  const name = clipSession.source?.name ?? "";
  job.stopIfSlow();
  stopSegmenting();
  try {
    const opened = await clipSession.run("override", () => engine.override(overrides));
    if (!opened) return;
    if (opened.ok) clipSession.clip.value = opened.clip;
    else reportFailure(action, name, opened.failure, () => setOverrides(overrides));
    await runDetection();
    if (!clipSession.signal.aborted) await runSegmentation();
  } catch (error) {
    reportFailure(action, name, error, () => setOverrides(overrides));
  }
});

/** Replaces the overrides and applies them. */
export function setOverrides(next: Overrides) {
  const clipSession = session.value;
  if (clipSession.isPreview) return;
  clipSession.overrides.value = next;
  overrideLatest(next);
}
