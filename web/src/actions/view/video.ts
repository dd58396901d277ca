/** Showing a video next to the open clip. The file stays on this computer; only its alignment is stored. */

import { effect } from "@preact/signals";
import {
  defaultAlignment,
  formatStoredVideo,
  isOffset,
  isVideoRate,
  parseStoredVideo,
  type Video,
} from "../../model/motion/video";
import { keyOfHash } from "../../model/stored/stored-changes";
import { type ClipSession, session } from "../../store/clip-session";
import { openClip } from "../../store/session";
import { showToast } from "../../store/toasts";
import { video } from "../../store/video";
import { announce } from "../../store/view";

/** Shows a video file next to the open clip. A file that was shown before retains its alignment. */
export function openVideo(file: File) {
  const clipSession = session.value;
  if (!openClip.value?.frames) {
    showToast({ text: `Open a clip with motion first, then drop its video ${file.name}.` });
    return;
  }
  const previous = clipSession.video.value;
  const isSame = previous?.name === file.name && previous.size === file.size;
  const { offset, rate } = isSame ? previous : defaultAlignment;
  releaseFile(previous);
  const url = URL.createObjectURL(file);
  clipSession.video.value = { name: file.name, size: file.size, offset, rate, url };
  clipSession.signal.addEventListener("abort", () => URL.revokeObjectURL(url));
  announce(`Video ${file.name} next to the view`);
}

function releaseFile(previous: Video | null) {
  if (previous?.url) URL.revokeObjectURL(previous.url);
}

/** Removes the video and forgets its alignment. */
export function removeVideo() {
  releaseFile(video.value);
  video.value = null;
  announce("Video removed");
}

/** Sets the time of the clip at which the video begins, in seconds. Ignores invalid values. */
export function setVideoOffset(offset: number) {
  if (video.value && isOffset(offset)) video.value = { ...video.value, offset };
}

/** Moves the beginning of the video by a number of frames of the clip. */
export function moveVideo(frames: number) {
  if (video.value) setVideoOffset(video.value.offset + frames / (openClip.value?.rate ?? 1));
}

/** Sets the seconds of the video per second of the clip. Ignores invalid values. */
export function setVideoRate(rate: number) {
  if (video.value && isVideoRate(rate)) video.value = { ...video.value, rate };
}

/** Reports that the browser cannot show the video; the clip remains usable. */
export function rejectVideo(problem: string) {
  if (video.value) video.value = { ...video.value, problem };
}

const storageKey = (clipSession: ClipSession) =>
  clipSession.storageKey.value?.replace(keyOfHash(""), "plantigrade:video:");

/** Restores the alignment of the video of each clip that is opened, and stores it when it changes. */
export function rememberVideos() {
  let restored: ClipSession | undefined;
  effect(() => {
    const clipSession = session.value;
    const key = storageKey(clipSession);
    void clipSession.video.value;
    if (!key) return;
    try {
      if (restored !== clipSession) {
        restored = clipSession;
        restore(clipSession, parseStoredVideo(localStorage.getItem(key)));
      }
      const current = clipSession.video.peek();
      if (current) localStorage.setItem(key, formatStoredVideo(current));
      else localStorage.removeItem(key);
    } catch {
      // The storage is denied or full: the alignment lasts until the page is closed.
    }
  });
}

/** Applies a stored record: to a video that is open already if it is the same, or as a reminder of it. */
function restore(clipSession: ClipSession, stored: Video | undefined) {
  const current = clipSession.video.peek();
  if (!stored) return;
  if (!current) clipSession.video.value = stored;
  else if (current.name === stored.name && current.size === stored.size) {
    clipSession.video.value = { ...current, offset: stored.offset, rate: stored.rate };
  }
}
