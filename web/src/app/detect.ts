import { batch } from "@preact/signals";
import { latest } from "../lib/latest";
import type { DetectOptions, Overrides } from "../worker/types";
import { rescore } from "./compare";
import { follow } from "./edit";
import { engine } from "./engine";
import { failTo, messageOf } from "./failing";
import { segmentNow, stopSegmenting } from "./segment";
import {
  clip,
  detectFailure,
  detection,
  failure,
  hero,
  loop,
  loopRegion,
  methods,
  options,
  overrides,
  source,
} from "./state";
import { createJob } from "./work";

async function listMethods() {
  if (!methods.value.length) methods.value = await engine.methods();
}

// Patient, as a worker that is ended has to read the file again.
const job = createJob("Finding plants in", 2000);

/** Whether labels of the present settings are on their way. */
export const detecting = job.busy;

/** Labels the clip on show; an answer that comes too late for it is dropped. */
export async function detectNow(asked: DetectOptions = options.value): Promise<void> {
  const about = clip.value;
  if (!about) return;
  try {
    const detected = await job.run(async (stoppable) => {
      // Asked for together: the worker must not wait for a page that draws.
      const listed = listMethods();
      const [detected] = await Promise.all([engine.detect(asked, stoppable), listed]);
      return detected;
    }, keepBefore);
    if (!detected || clip.value !== about) return;
    batch(() => {
      detection.value = detected.ok ? detected.detection : null;
      detectFailure.value = detected.ok ? null : detected.failure;
      follow();
      // Plants have moved: a loop on one of them would repeat something else.
      if (loop.value === "plant") {
        loop.value = "clip";
        loopRegion.value = null;
      }
    });
    await rescore();
  } catch (error) {
    if (clip.value !== about) return;
    batch(() => {
      detection.value = null;
      detectFailure.value = { message: messageOf(error), hint: "Change a setting to try again." };
    });
  }
}

/** After a person has stopped it, the settings are again those of the labels on show. */
function keepBefore() {
  batch(() => {
    if (detection.value) options.value = detection.value.options;
    else
      detectFailure.value = { message: "it was cancelled", hint: "Change a setting to try again." };
  });
}

const detectLatest = latest(detectNow);

export function setOptions(change: Partial<DetectOptions>) {
  options.value = { ...options.value, ...change };
  job.hurry();
  detectLatest(options.value);
}

const overrideLatest = latest(async (asked: Overrides) => {
  const about = source.value;
  job.hurry();
  stopSegmenting();
  try {
    const opened = await engine.override(asked);
    if (source.value !== about) return;
    if (opened.ok) clip.value = opened.clip;
    else
      failure.value = { name: about?.name ?? "", what: "read that way", failure: opened.failure };
    await detectNow();
    if (source.value === about) await segmentNow();
  } catch (error) {
    failTo("read that way", about?.name ?? "", error);
  }
});

/** Replaces what a person corrected; at once in force. */
export function setOverrides(next: Overrides) {
  if (hero.value) return;
  overrides.value = next;
  overrideLatest(next);
}
