import { batch } from "@preact/signals";
import { latest } from "../lib/latest";
import { type Action, renamed, sameAction } from "../lib/segments";
import type { SegmentOptions } from "../worker/types";
import { rescoreSegments } from "./compare";
import { engine } from "./engine";
import { messageOf } from "./failing";
import {
  clip,
  loop,
  loopRegion,
  renaming,
  segmentation,
  segmentFailure,
  segmentMethods,
  segmentNames,
  segmentOptions,
  sheetOpen,
  tab,
} from "./state";
import { createJob } from "./work";

const job = createJob("Finding segments in", 300);

async function listMethods() {
  if (!segmentMethods.value.length) segmentMethods.value = await engine.segmentMethods();
}

/** Cuts the clip on show into actions; an answer that comes too late for it is dropped. */
export async function segmentNow(asked: SegmentOptions = segmentOptions.value): Promise<void> {
  if (!clip.value?.frames) return;
  try {
    const segmented = await job.run(async (stoppable) => {
      // Asked for together: the worker must not wait for a page that draws.
      const listed = listMethods();
      const [segmented] = await Promise.all([engine.segment(asked, stoppable), listed]);
      return segmented;
    }, keepBefore);
    if (!segmented) return;
    batch(() => {
      segmentation.value = segmented.ok ? segmented.segmentation : null;
      segmentFailure.value = segmented.ok ? null : segmented.failure;
      moveLoop();
    });
    await rescoreSegments();
  } catch (error) {
    batch(() => {
      segmentation.value = null;
      segmentFailure.value = { message: messageOf(error), hint: "Change a setting to try again." };
    });
  }
}

/** Ends a segmentation that nobody waits for any more. */
export const stopSegmenting = job.stop;

/** After a person has stopped it, the settings are again those of what is shown. */
function keepBefore() {
  batch(() => {
    if (segmentation.value) segmentOptions.value = segmentation.value.options;
    else
      segmentFailure.value = { message: "it was cancelled", hint: "Choose a method to try again." };
  });
}

/** The loop goes on with the segment that is the same action, if there is one. */
function moveLoop() {
  if (loop.value !== "segment" || !loopRegion.value) return;
  const same = sameAction(segmentation.value?.segments ?? [], loopRegion.value);
  loopRegion.value = same ?? null;
  if (!same) loop.value = "clip";
}

const segmentLatest = latest((asked: SegmentOptions) => segmentNow(asked));

/** Puts options in place of those before; at once in force. */
export function setSegmentOptions(next: SegmentOptions) {
  segmentOptions.value = next;
  job.hurry();
  segmentLatest(next);
}

/** Gives an action a name that lasts as long as there is such an action. */
export function rename(action: Action, name: string) {
  segmentNames.value = renamed(segmentNames.value, action, name);
}

/** Takes a person to the field with the name of an action. */
export function askForName(action: Action) {
  batch(() => {
    tab.value = "segment";
    sheetOpen.value = true;
    renaming.value = action;
  });
}
