import { computed, signal } from "@preact/signals";
import type { Companion } from "../model/source";
import { openClip, source } from "./session";

/** Clips shown side by side with the open one, in the order in which they were added. */
export const companions = signal<readonly Companion[]>([]);

/** The companions that are shown: not those of the start page, nor the open clip itself. */
export const shownCompanions = computed(() =>
  openClip.value ? companions.value.filter((other) => other.source !== source.value) : [],
);

/** Maximum number of companions. */
export const maxCompanions = 5;
