import { computed, effect, signal } from "@preact/signals";
import { reachOf } from "../lib/evidence";
import { latest } from "../lib/latest";
import { principalPart } from "../lib/plants";
import { Cancelled } from "../worker";
import type { Part, Side, Why } from "../worker/types";
import { engine } from "./engine";
import { failTo } from "./failing";
import { clip, detection, openClip, playhead, playing, tab } from "./state";

/** A frame that a pointer or a key rests on. */
export interface Pointed {
  frame: number;
  /** The foot whose point it is; both, where the timeline is pointed at. */
  side?: Side;
}

/** Nothing, as long as the Why tab is not on show. */
export const pointed = signal<Pointed | null>(null);

/** Why the feet are taken for planted; null until it is known. */
export const why = signal<Why | null>(null);

/** The part that was chosen to be explained. */
const chosenPart = signal<Part | null>(null);

export const whyOpen = computed(() => tab.value === "why" && openClip.value !== null);

/** The part that is explained: the one chosen, or the one that says best when a foot is down. */
export const whyPart = computed(() => {
  const parts = detection.value?.parts ?? {};
  const chosen = chosenPart.value;
  return chosen && parts[chosen] ? chosen : principalPart(parts);
});

export function explain(part: Part) {
  chosenPart.value = part;
}

/** The moment that the view shows: that of the point under the pointer, or the playhead's. */
export const momentShown = computed(() => {
  const point = pointed.value;
  return point?.side && !playing.value ? point.frame : playhead.value;
});

export const shownFrame = computed(() => Math.floor(momentShown.value + 1e-6));

/** The view shows another moment than the playhead's. */
export const isElsewhere = computed(() => momentShown.value !== playhead.value);

export function point(sample: Pointed | undefined) {
  const before = pointed.peek();
  if (sample?.frame === before?.frame && sample?.side === before?.side) return;
  pointed.value = sample ?? null;
}

const ask = latest(async ({ part, about }: { part: Part; about: unknown }) => {
  const tracks = detection.value?.parts[part];
  if (!tracks || clip.value !== about) return;
  try {
    const found = await engine.why(part, reachOf(tracks));
    // What is asked while a slider moves may be of the next labels already: those are on their way.
    if (clip.value === about && found) why.value = found;
  } catch (error) {
    if (clip.value === about && !(error instanceof Cancelled)) {
      failTo("explained", clip.value?.name ?? "", error);
    }
  }
});

/** Keeps the evidence at what the labels are, as long as somebody looks; returns how to stop. */
export function followWhy(): () => void {
  const stop = effect(() => {
    const part = whyPart.value;
    if (!detection.value || !part) why.value = null;
    else ask({ part, about: clip.value });
  });
  return () => {
    stop();
    pointed.value = null;
    why.value = null;
  };
}

// Another clip has other frames.
effect(() => {
  void clip.value;
  pointed.value = null;
  why.value = null;
});
