/** The tour for new users. */

import { batch, computed, signal } from "@preact/signals";
import { tableVisible } from "./batch";
import { openClip, source } from "./session";

const storageKey = "plantigrade:tour";

/** Index of the current hint; null after the tour. */
const step = signal(isDone() ? null : 0);

/** True once the user has asked for the tour. */
const isRequested = signal(false);

/**
 * Index of the hint that is shown, if any. The tour does not start by itself with the clip of a link or of a shared
 * page, which has a view state: who receives it wants to see the clip. The table hides it.
 */
export const tourStep = computed(() =>
  openClip.value && !tableVisible.value && (isRequested.value || !source.value?.view)
    ? step.value
    : null,
);

function isDone() {
  try {
    return localStorage.getItem(storageKey) === "done";
  } catch {
    return true;
  }
}

/** The part of the page that each hint describes. */
const targets = ["viewer", "timeline", "timeline", "panel", "head"];

/** The part of the page that the shown hint describes. */
export const hintTarget = computed(() =>
  tourStep.value === null ? undefined : targets[tourStep.value],
);

/** Shows a hint of the tour. */
export function showHint(index: number) {
  batch(() => {
    isRequested.value = true;
    step.value = index;
  });
}

export function endTour() {
  step.value = null;
  try {
    localStorage.setItem(storageKey, "done");
  } catch {
    // Without storage, the tour is shown again on the next visit.
  }
}
