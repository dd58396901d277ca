/** What is measured of the clip by its labels, once somebody looks. */

import { effect, signal } from "@preact/signals";
import type { Gait } from "../worker/types";
import { engine } from "./engine";
import { detection, openClip, tab } from "./state";

/** How the person walks; absent until it is known, and where nobody walks. */
export const gait = signal<Gait | undefined>(undefined);

effect(() => {
  const labels = detection.value;
  if (!openClip.value || !labels || tab.value !== "clip") {
    gait.value = undefined;
    return;
  }
  void measure(labels);
});

async function measure(labels: typeof detection.value) {
  const measured = await engine.gait().catch(() => undefined);
  if (detection.value === labels) gait.value = measured;
}
