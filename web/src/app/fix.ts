/** Foot skate: how far planted feet slide, and the clip without that. */

import { batch, effect, signal } from "@preact/signals";
import { stemOf } from "../lib/names";
import { Cancelled } from "../worker";
import type { Cleaned } from "../worker/types";
import { engine } from "./engine";
import { failTo } from "./failing";
import { handOver } from "./handOver";
import { announcement, clip, detection, overrides } from "./state";
import { withProgress } from "./work";

/** The clip with its planted feet held still; null until somebody asks for it. */
export const cleaned = signal<Cleaned | null>(null);

export const cleaning = signal(false);

/** What the view shows: the clip as it was, as it is cleaned, or the one over the other. */
export type Shown = "before" | "after" | "both";
export const shown = signal<Shown>("before");

/** Labels that change, or a clip read in another way, make another clip of it. */
effect(() => {
  void [clip.value, detection.value, overrides.value];
  batch(() => {
    cleaned.value = null;
    shown.value = "before";
  });
});

/** Holds the planted feet of the clip on show still. */
export async function clean(): Promise<void> {
  const [about, labels] = [clip.value, detection.value];
  if (!about || !labels || cleaning.value) return;
  cleaning.value = true;
  try {
    const made = await withProgress({ what: "Cleaning" }, new AbortController(), engine.clean);
    if (detection.value !== labels) return;
    batch(() => {
      cleaned.value = made;
      shown.value = "both";
      announcement.value = "Cleaned: the view shows the clip before as a ghost";
    });
  } catch (error) {
    if (detection.value === labels && !(error instanceof Cancelled)) {
      failTo("cleaned", about.name, error);
    }
  } finally {
    cleaning.value = false;
  }
}

/** Hands the cleaned clip to the browser as a download. */
export async function saveCleaned(): Promise<void> {
  const name = `${stemOf(clip.value?.name ?? "clip")}.clean.bvh`;
  await handOver(name, () =>
    withProgress({ what: "Writing" }, new AbortController(), engine.saveCleaned),
  );
}
