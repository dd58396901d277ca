/**
 * Holds a video element in step with the playhead.
 *
 * Browsers show the pictures of a video element on their own, also while the page draws the 3D view. The pictures
 * are therefore drawn onto a canvas over the element, each with the moment to which it belongs.
 *
 * While paused, the element seeks to the moment of the playhead. During playback, the element is the clock: the
 * playhead follows the picture on show, because a decoder starts late and drops pictures. Where the video cannot
 * play (backwards, before its beginning and after its end, or at speeds that the browser does not support), the
 * clock of the page applies and the element follows it by seeking.
 */

import { effect } from "@preact/signals";
import { pause } from "../actions/view/playback";
import { rejectVideo } from "../actions/view/video";
import { toMoment, toVideoTime } from "../model/motion/video";
import { direction, playhead, playing, speed } from "../store/playback";
import { openClip } from "../store/session";
import { mediaClock, video, videoDuration, videoMuted } from "../store/video";
import { stageHandle } from "../store/view";

/**
 * Time by which seeking goes beyond the target, in seconds: formats round the times of pictures, WebM to
 * milliseconds, so that the picture at the target may begin slightly after it.
 */
const seekBias = 0.0015;

/** Rates that browsers play. */
const playableRates = { min: 0.0625, max: 16 };

/** Assumed duration of a picture, in seconds, before two pictures were shown. */
const defaultPictureTime = 0.05;

/** Times between pictures after which the shortest is their duration: not all of them were dropped. */
const minPictureTimes = 8;

/** Time after the end of a seek within which a busy browser presents its picture, in milliseconds. */
const maxDelay = 500;

/** Time for which playback waits for a picture, in milliseconds; then the clock of the page applies. */
const maxWait = 2000;

/**
 * Shows the video at `url` in an element and on the canvas over it, in step with the playhead. Returns a function
 * that ends it.
 */
export function synchronizeVideo(
  element: HTMLVideoElement,
  canvas: HTMLCanvasElement,
  url: string,
): () => void {
  const controller = new AbortController();
  const { signal } = controller;
  /** Time of the last picture on show, and when it was shown by the clock of the page, in milliseconds. */
  let picture: { time: number; shownAt: number } | undefined;
  /** Shortest time between pictures, in seconds, and the number of times from which it is known. */
  let pictureTime = Number.POSITIVE_INFINITY;
  let pictureTimes = 0;
  /** Moment that the clock returned last; the user moved the playhead if it has another one. */
  let lastMoment: number | undefined;
  /** Start of the wait for a picture, in milliseconds. */
  let waitingSince: number | undefined;

  const clipRate = () => openClip.peek()?.rate ?? 1;
  const targetTime = (moment: number) => {
    const current = video.peek();
    return current ? toVideoTime(moment, clipRate(), current) : 0;
  };
  const clamped = (time: number) =>
    Math.min(Math.max(time + seekBias, 0), Math.max(0, (element.duration || 0) - 1e-3));

  /** Target of a seek that waits for the current one to finish. */
  let nextSeek: number | undefined;
  const seek = (time: number) => {
    if (element.readyState < HTMLMediaElement.HAVE_METADATA) return;
    const target = clamped(time);
    if (element.seeking) nextSeek = target;
    else if (Math.abs(element.currentTime - target) > 1e-4) element.currentTime = target;
  };
  const onSeeked = () => {
    const target = nextSeek;
    nextSeek = undefined;
    if (target !== undefined) element.currentTime = target;
    else {
      const isDrawing = performance.now() < drawUntil;
      drawUntil = performance.now() + maxDelay;
      if (!isDrawing) drawRepeatedly();
    }
  };
  let drawUntil = 0;
  /** Draws the current picture in each animation frame, while the element is paused. */
  const drawRepeatedly = () => {
    if (element.paused && !element.seeking) drawPicture();
    if (!signal.aborted && performance.now() < drawUntil) requestAnimationFrame(drawRepeatedly);
  };

  const hasCallbacks: boolean = "requestVideoFrameCallback" in HTMLVideoElement.prototype;
  const ctx = canvas.getContext("2d", { alpha: false });
  canvas.hidden = !hasCallbacks;
  /**
   * Draws the current picture. Returns its time in seconds if the browser tells it: the video may have advanced
   * since the callback for the picture was requested.
   */
  const drawPicture = (): number | undefined => {
    const { videoWidth, videoHeight } = element;
    if (!ctx || !videoWidth) return undefined;
    const scale = Math.min(1, (element.clientWidth * devicePixelRatio) / videoWidth || 1);
    const [width, height] = [Math.ceil(videoWidth * scale), Math.ceil(videoHeight * scale)];
    if (canvas.width !== width || canvas.height !== height)
      Object.assign(canvas, { width, height });
    if (typeof VideoFrame === "function") {
      try {
        const current = new VideoFrame(element);
        ctx.drawImage(current, 0, 0, width, height);
        const time = current.timestamp / 1e6;
        current.close();
        return time;
      } catch {
        // The element has no picture at the moment.
        return undefined;
      }
    }
    ctx.drawImage(element, 0, 0, width, height);
    return undefined;
  };
  const onPicture = (_: number, metadata: VideoFrameCallbackMetadata) => {
    const time = drawPicture() ?? metadata.mediaTime;
    // During a seek, the picture before it may still be shown.
    if (!element.seeking) {
      const step = picture && time - picture.time;
      // A faster video skips pictures.
      if (step && step > 0 && element.playbackRate <= 1) {
        pictureTime = Math.min(pictureTime, step);
        pictureTimes++;
      }
      picture = { time, shownAt: metadata.expectedDisplayTime };
    }
    element.requestVideoFrameCallback(onPicture);
  };
  if (hasCallbacks) element.requestVideoFrameCallback(onPicture);

  /** Returns the time of the picture on show, in seconds, with the time since it was shown. */
  const shownTime = () => {
    if (!hasCallbacks) return element.currentTime;
    if (!picture) return undefined;
    const since = Math.max(0, (performance.now() - picture.shownAt) / 1000) * element.playbackRate;
    const rate = video.peek()?.rate ?? 1;
    // Until the duration of a picture is known, the picture on show may be the next one at most.
    const limit = pictureTimes >= minPictureTimes ? pictureTime : rate / clipRate();
    // Formats round the times of pictures.
    return picture.time + Math.min(Math.max(since, seekBias), 0.99 * limit);
  };

  /** Returns the time at which the last picture begins, in seconds, as far as it is known. */
  const lastPictureTime = () =>
    element.duration - (Number.isFinite(pictureTime) ? pictureTime : defaultPictureTime);

  /** Starts playback at a time of the video; the pictures before the seek do not count. */
  const startAt = (time: number, rate: number) => {
    picture = undefined;
    element.playbackRate = rate;
    seek(time);
    element.play().catch(() => {
      // Playback was interrupted by a pause or a seek.
    });
  };

  const wait = (moment: number) => {
    const now = performance.now();
    waitingSince ??= now;
    return now - waitingSince < maxWait ? moment : undefined;
  };

  const clock = {
    momentAt(expected: number): number | undefined {
      const current = video.peek();
      const from = playhead.peek();
      const rate = current ? speed.peek() * current.rate : 0;
      const time = targetTime(expected);
      const canPlay =
        current &&
        direction.peek() > 0 &&
        rate >= playableRates.min &&
        rate <= playableRates.max &&
        element.readyState >= HTMLMediaElement.HAVE_METADATA &&
        time >= 0 &&
        time < lastPictureTime();
      if (!canPlay) {
        if (!element.paused) element.pause();
        seek(time);
        lastMoment = undefined;
        waitingSince = undefined;
        return undefined;
      }
      if (element.paused || from !== lastMoment) {
        startAt(targetTime(from) < 0 ? 0 : targetTime(from), rate);
        lastMoment = from;
        waitingSince = undefined;
        return from;
      }
      if (element.playbackRate !== rate) element.playbackRate = rate;
      const shown = element.seeking ? undefined : shownTime();
      if (shown === undefined) {
        const held = wait(from);
        lastMoment = held;
        return held;
      }
      waitingSince = undefined;
      // The first picture after a seek may begin before its target.
      lastMoment = Math.max(from, toMoment(shown, clipRate(), current));
      return lastMoment;
    },
  };
  mediaClock.current = clock;

  const stop = effect(() => {
    const isPlaying = playing.value;
    const moment = playhead.value;
    void video.value;
    void openClip.value;
    if (isPlaying) {
      // The view would otherwise be drawn in the next animation frame, with the next picture.
      if (lastMoment !== undefined) queueMicrotask(() => stageHandle.peek()?.flush());
      return;
    }
    if (!element.paused) element.pause();
    lastMoment = undefined;
    seek(targetTime(moment));
  });
  const stopMuting = effect(() => {
    element.muted = videoMuted.value;
  });
  const onReady = () => {
    if (!element.videoWidth) {
      rejectVideo("It has no picture that this browser can decode.");
      return;
    }
    videoDuration.value = Number.isFinite(element.duration) ? element.duration : undefined;
    seek(targetTime(playhead.peek()));
  };
  const onError = () => {
    if (!element.getAttribute("src")) return;
    pause();
    rejectVideo(
      "This browser cannot decode it. Convert it to MP4 (H.264) or WebM (VP9), and choose it again.",
    );
  };
  element.addEventListener("seeked", onSeeked, { signal });
  element.addEventListener("loadeddata", onReady, { signal });
  element.addEventListener("error", onError, { signal });
  element.src = url;
  return () => {
    controller.abort();
    stop();
    stopMuting();
    if (mediaClock.current === clock) mediaClock.current = null;
    videoDuration.value = undefined;
    element.removeAttribute("src");
    element.load();
  };
}
