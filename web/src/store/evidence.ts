/** The evidence tab: the explained part, and the frame that the pointer is on. */

import { computed, signal } from "@preact/signals";
import { principalPart } from "../model/plants/plants";
import type { Part } from "../model/types";
import { type PointedFrame, sessionField } from "./clip-session";
import { playhead, playing } from "./playback";
import { detection, openClip } from "./session";
import { activeTab } from "./view";

export type { PointedFrame } from "./clip-session";

/** Evidence for the labels of `evidencePart`; null until the worker has answered. */
export const evidence = sessionField((open) => open.evidence);

/** The frame under the pointer; null unless the evidence tab is open. */
export const pointedFrame = sessionField((open) => open.pointedFrame);

/** The part that the user chose. */
export const chosenPart = signal<Part | null>(null);

export const evidenceOpen = computed(
  () => activeTab.value === "evidence" && openClip.value !== null,
);

/** The explained part: the chosen one if it is labelled, otherwise the principal part. */
export const evidencePart = computed(() => {
  const parts = detection.value?.parts ?? {};
  const chosen = chosenPart.value;
  return chosen && parts[chosen] ? chosen : principalPart(parts);
});

/** The moment that the viewer shows: the frame under the pointer, otherwise the playhead. */
export const shownMoment = computed(() => {
  const pointed = pointedFrame.value;
  return pointed?.side && !playing.value ? pointed.frame : playhead.value;
});

export const shownFrame = computed(() => Math.floor(shownMoment.value + 1e-6));

/** True if the viewer shows another moment than the playhead. */
export const isFramePreviewed = computed(() => shownMoment.value !== playhead.value);

/** Points at a frame, or at none. */
export function pointAt(pointed: PointedFrame | undefined) {
  const before = pointedFrame.peek();
  if (pointed?.frame === before?.frame && pointed?.side === before?.side) return;
  pointedFrame.value = pointed ?? null;
}
