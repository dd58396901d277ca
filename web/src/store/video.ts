/** The video next to the clip, and the clock that it is during playback. */

import { signal } from "@preact/signals";
import { sessionField } from "./clip-session";

/** The video next to the open clip; null if there is none. */
export const video = sessionField((open) => open.video);

/** Duration of the video, in seconds; undefined until it is known. */
export const videoDuration = signal<number | undefined>(undefined);

/** True if the sound of the video is off. */
export const videoMuted = signal(true);

/** A medium that determines the moment during playback, because only it knows which picture is on show. */
export interface MediaClock {
  /**
   * Returns the moment of the picture on show, in frames of the clip. `expected` is the moment by the clock of
   * the page. Undefined if the medium does not play at that moment; then the clock of the page applies.
   */
  momentAt(expected: number): number | undefined;
}

/** The clock of the video on show; null if there is none. */
export const mediaClock: { current: MediaClock | null } = { current: null };
