/** The tour for new users. */

import { signal } from "@preact/signals";

const storageKey = "plantigrade:tour";

/** Index of the current hint; null after the tour. */
export const tourStep = signal(isDone() ? null : 0);

function isDone() {
  try {
    return localStorage.getItem(storageKey) === "done";
  } catch {
    return true;
  }
}

/** Starts the tour at the first hint. */
export function startTour() {
  tourStep.value = 0;
}

export function endTour() {
  tourStep.value = null;
  try {
    localStorage.setItem(storageKey, "done");
  } catch {
    // Without storage, the tour is shown again on the next visit.
  }
}
