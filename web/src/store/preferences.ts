/** Choices of the user about the page; the browser stores them. */

import { type Signal, signal } from "@preact/signals";
import { isFramed } from "./embedded";

const prefix = "plantigrade.";

/** A signal that is stored in this browser. */
export interface Preference<T> {
  readonly value: T;
  peek(): T;
  /** Changes and stores the value. */
  set(value: T): void;
}

/**
 * Returns a preference with its stored value, or the default if none is stored or `isValid` rejects it.
 * Private windows may forbid storage; the value then lasts until the page is closed.
 */
export function preference<T>(
  name: string,
  defaultValue: T,
  isValid: (value: unknown) => value is T,
): Preference<T> {
  const state: Signal<T> = signal(read());
  function read(): T {
    try {
      const text = localStorage.getItem(prefix + name);
      const value: unknown = text === null ? undefined : JSON.parse(text);
      return isValid(value) ? value : defaultValue;
    } catch {
      return defaultValue;
    }
  }
  return {
    get value() {
      return state.value;
    },
    peek: () => state.peek(),
    set(value) {
      state.value = value;
      try {
        localStorage.setItem(prefix + name, JSON.stringify(value));
      } catch {
        // See above.
      }
    },
  };
}

const isBoolean = (value: unknown): value is boolean => typeof value === "boolean";
const isSize = (value: unknown): value is number | null =>
  value === null || (typeof value === "number" && value > 0 && value < 10_000);

/** True if the keys are the former ones: L loops, K splits, comma and full stop change the speed. */
export const classicKeys = preference("classic-keys", false, isBoolean);

/** Height of the tracks of the timeline, in pixels; null for the default of the page size. */
export const timelineHeight = preference("timeline-height", null, isSize);

/** Width of the side panel, in pixels; null for the default. */
export const panelWidth = preference("panel-width", null, isSize);

/** Width of the video next to the view, in pixels; null for the default. */
export const videoWidth = preference("video-width", null, isSize);

/** True if the side panel is hidden, as it is in a frame at first. */
export const panelCollapsed = preference("panel-collapsed", isFramed, isBoolean);

/** Groups of tracks that the timeline can hide. */
export const trackGroups = ["parts", "curves", "segments"] as const;
export type TrackGroup = (typeof trackGroups)[number];

/** Groups of tracks that the timeline does not show. */
export const hiddenTracks = preference<readonly TrackGroup[]>(
  "hidden-tracks",
  [],
  (value): value is readonly TrackGroup[] =>
    Array.isArray(value) && value.every((item) => trackGroups.includes(item)),
);
