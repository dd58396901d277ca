import { computed, signal } from "@preact/signals";
import type { Companion } from "../model/sources/source";
import { openBatchRow, tableNumber } from "./batch";
import { openClip, source } from "./session";

/** Clips shown side by side with open ones, in the order in which they were added. */
export const companions = signal<readonly Companion[]>([]);

/** The companions of the open clip: those that were added to it, or to another clip of the same table. */
export const ownCompanions = computed(() => {
  const table = openBatchRow.value && tableNumber.value;
  return companions.value.filter(
    (other) => other.addedTo === source.value || other.table === table,
  );
});

/** The companions that are shown: not those of the start page, nor the open clip itself, opened from wherever. */
export const shownCompanions = computed(() => {
  if (!openClip.value) return [];
  const own = [source.value, openBatchRow.value?.source];
  return ownCompanions.value.filter((other) => !own.includes(other.source));
});

/** Maximum number of companions. */
export const maxCompanions = 5;
