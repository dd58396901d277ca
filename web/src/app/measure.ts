/** What is measured of the clip by its labels, once somebody looks. */

import { batch, effect, signal } from "@preact/signals";
import type { Gait, Slide } from "../worker/types";
import { engine } from "./engine";
import { detection, openClip, tab } from "./state";

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
  const measured = await Promise.all([
    engine.gait().catch(() => undefined),
    engine.skate().catch(() => []),
  ]);
  if (detection.value !== labels) return;
  batch(() => {
    [gait.value, slides.value] = measured;
  });
}
