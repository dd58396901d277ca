import { computed, signal } from "@preact/signals";
import type { Companion } from "../model/sources/source";
import { openBatchRow } from "./batch";
import { openClip, source } from "./session";

/** Clips shown side by side with the open one, in the order in which they were added. */
export const companions = signal<readonly Companion[]>([]);

/** The companions that are shown: not those of the start page, nor the open clip itself, opened from wherever. */
export const shownCompanions = computed(() => {
  if (!openClip.value) return [];
  const own = [source.value, openBatchRow.value?.source];
  return companions.value.filter((other) => !own.includes(other.source));
});

/** Maximum number of companions. */
export const maxCompanions = 5;
