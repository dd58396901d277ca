/** What is measured of the clip by its labels, once somebody looks. */

import { batch, effect, signal } from "@preact/signals";
import { Cancelled } from "../worker";
import type { Gait, Slide } from "../worker/types";
import { engine } from "./engine";
import { failTo } from "./failing";
import { detection, openClip, tab } from "./state";
import { withProgress } from "./work";

/** How far every plant slides; empty until it is known. */
export const slides = signal<readonly Slide[]>([]);

/** How the person walks; absent until it is known, and where nobody walks. */
export const gait = signal<Gait | undefined>(undefined);

effect(() => {
  const labels = detection.value;
  if (!openClip.value || !labels || tab.value !== "clip") {
    gait.value = undefined;
    slides.value = [];
    return;
  }
  void measure(labels);
});

async function measure(labels: typeof detection.value) {
  try {
    const measured = await withProgress({ what: "Measuring" }, new AbortController(), (stoppable) =>
      Promise.all([engine.gait(stoppable), engine.skate(stoppable)]),
    );
    if (detection.value !== labels) return;
    batch(() => {
      [gait.value, slides.value] = measured;
    });
  } catch (error) {
    if (detection.value === labels && !(error instanceof Cancelled)) {
      failTo("measured", openClip.value?.name ?? "", error);
    }
  }
}
