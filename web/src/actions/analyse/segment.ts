/** Segmenting the clip into actions, and naming them. */

import { batch } from "@preact/signals";
import { engine } from "../../engine";
import { failureOf } from "../../model/failure";
import { matchingRange, type NamedSegment, renameSegment } from "../../model/segments/segments";
import type { SegmentOptions } from "../../model/types";
import { type ClipSession, session } from "../../store/clip-session";
import { createExclusiveJob } from "../../store/jobs";
import { renamedSegment, segmentNames } from "../../store/session";
import { segmentFormats, segmentMethods, segmentOptions } from "../../store/settings";
import { showTab } from "../../store/view";
import { latestOnly } from "../../util/latest-only";
import { applyCutEdits } from "../edit/cuts";
import { updateCutScores } from "./compare";

const job = createExclusiveJob("Segmenting", 300);

async function listMethodsAndFormats() {
  if (segmentMethods.value.length) return;
  const [methods, formats] = await Promise.all([engine.segmentMethods(), engine.segmentFormats()]);
  batch(() => {
    segmentMethods.value = methods;
    segmentFormats.value = formats;
  });
}

let segmenting: Promise<void> = Promise.resolve();

/** Resolves when the segments of all options chosen so far are shown, or their segmentation has ended without. */
export const segmentingDone = (): Promise<void> => segmenting;

/** Segments the open clip. */
export function runSegmentation(options: SegmentOptions = segmentOptions.value): Promise<void> {
  segmenting = segment(options);
  return segmenting;
}

async function segment(options: SegmentOptions): Promise<void> {
  const clipSession = session.value;
  if (!clipSession.clip.value?.frames) return;
  try {
    const segmented = await clipSession.run("segment", () =>
      job.run(
        async (callOptions) => {
          // Requested together, so that the worker need not wait for the page.
          const listed = listMethodsAndFormats();
          const [segmented] = await Promise.all([engine.segment(options, callOptions), listed]);
          return segmented;
        },
        () => revertOptions(clipSession),
      ),
    );
    if (!segmented) return;
    batch(() => {
      clipSession.segmentation.value = segmented.ok ? segmented.segmentation : null;
      clipSession.segmentFailure.value = segmented.ok ? null : segmented.failure;
      clipSession.selectedCut.value = null;
      moveLoop(clipSession);
    });
    await Promise.all([applyCutEdits(clipSession), updateCutScores(clipSession)]);
  } catch (error) {
    batch(() => {
      clipSession.segmentation.value = null;
      clipSession.segmentFailure.value = failureOf(error);
    });
  }
}

/** Stops a segmentation whose result is no longer needed. */
export const stopSegmenting = job.stop;

/** After the user stopped a segmentation, restores the options of the one that is shown. */
function revertOptions(clipSession: ClipSession) {
  batch(() => {
    const segmentation = clipSession.segmentation.value;
    if (segmentation) segmentOptions.value = segmentation.options;
    else
      clipSession.segmentFailure.value = {
        message: "it was cancelled",
        hint: "Choose a method to try again.",
      };
  });
}

/** Moves a segment loop to the segment of the same action, or ends it. */
function moveLoop(clipSession: ClipSession) {
  const { loop, loopRegion, segmentation } = clipSession;
  if (loop.value !== "segment" || !loopRegion.value) return;
  const same = matchingRange(segmentation.value?.segments ?? [], loopRegion.value);
  loopRegion.value = same ?? null;
  if (!same) loop.value = "clip";
}

const segmentLatest = latestOnly((options: SegmentOptions) => runSegmentation(options));

/** Replaces the options and segments again. */
export function setSegmentOptions(next: SegmentOptions) {
  segmentOptions.value = next;
  job.stopIfSlow();
  segmenting = segmentLatest(next);
}

/**
 * Names a segment. The name applies to all segments with the same action that have no name of their own, and
 * to every segmentation that contains this segment.
 */
export function setSegmentName(segment: NamedSegment, name: string) {
  segmentNames.value = renameSegment(segmentNames.value, segment, name);
}

/** Focuses the name field of a segment. */
export function editSegmentName(segment: NamedSegment) {
  batch(() => {
    showTab("segment");
    renamedSegment.value = segment;
  });
}
