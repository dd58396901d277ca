import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { pickVideo } from "../actions/open/pick-files";
import { removeVideo, setVideoOffset, setVideoRate } from "../actions/view/video";
import { type Video, videoRates } from "../model/motion/video";
import { videoWidth } from "../store/preferences";
import { openClip } from "../store/session";
import { video, videoMuted } from "../store/video";
import { Icon } from "../ui/icons";
import { Splitter, setSize } from "../ui/Splitter";
import { formatBytes } from "../util/format";
import { synchronizeVideo } from "./video-sync";

/** The video next to the view, with its alignment. */
export function VideoPane() {
  const pane = useRef<HTMLElement | null>(null);
  const isAligning = useSignal(false);
  const shown = video.value;
  const width = videoWidth.value;
  if (!shown) return null;
  return (
    <section
      class="video-pane"
      aria-label="Video"
      ref={(element) => {
        pane.current = element;
        setSize(element, "--video-width", width);
      }}
    >
      <Splitter
        label="Width of the video"
        orientation="vertical"
        size={videoWidth}
        measure={() => pane.current?.clientWidth ?? 0}
      />
      <div class="video-head">
        <strong title={shown.name}>{shown.name}</strong>
        {shown.url && !shown.problem && (
          <>
            <button
              type="button"
              class="button"
              aria-expanded={isAligning.value}
              aria-controls="video-alignment"
              title="Offset and rate of the video"
              onClick={() => {
                isAligning.value = !isAligning.value;
              }}
            >
              Align
            </button>
            <button
              type="button"
              class="button icon-only"
              aria-pressed={!videoMuted.value}
              aria-label="Sound"
              title={videoMuted.value ? "Sound is off" : "Sound is on"}
              onClick={() => {
                videoMuted.value = !videoMuted.value;
              }}
            >
              <Icon name={videoMuted.value ? "muted" : "sound"} />
            </button>
          </>
        )}
        <button
          type="button"
          class="button icon-only"
          aria-label="Remove the video"
          title="Remove the video"
          onClick={removeVideo}
        >
          <Icon name="close" />
        </button>
      </div>
      {isAligning.value && shown.url && !shown.problem && <Alignment shown={shown} />}
      <Picture shown={shown} />
    </section>
  );
}

/** The picture, or why there is none. */
function Picture({ shown: { name, size, url, problem } }: { shown: Video }) {
  const element = useRef<HTMLVideoElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (!url || problem || !element.current || !canvas.current) return undefined;
    return synchronizeVideo(element.current, canvas.current, url);
  }, [url, problem]);
  if (problem) {
    return (
      <div class="video-message" role="alert">
        <p>
          <strong>{name} cannot be shown.</strong> {problem}
        </p>
        <button type="button" class="button" onClick={pickVideo}>
          Choose another video
        </button>
      </div>
    );
  }
  if (!url) {
    return (
      <div class="video-message">
        <p>
          <strong>{name}</strong> ({formatBytes(size)}) was shown next to this clip. Its alignment
          is stored, but videos are not: choose the file again.
        </p>
        <button type="button" class="button" onClick={pickVideo}>
          Choose video
        </button>
      </div>
    );
  }
  return (
    <div class="video-picture">
      <video ref={element} aria-label={`Video ${name}`} muted playsInline preload="auto" />
      <canvas ref={canvas} />
    </div>
  );
}

/** Number fields for offset and rate. */
function Alignment({ shown: { offset, rate } }: { shown: Video }) {
  const clipRate = openClip.value?.rate ?? 1;
  const rounded = (value: number, decimals: number) => String(Number(value.toFixed(decimals)));
  return (
    <div class="video-alignment" id="video-alignment">
      <label title="Time of the clip at which the video begins">
        <span>Offset, s</span>
        <input
          class="input"
          type="number"
          step="0.01"
          value={rounded(offset, 4)}
          onChange={(event) => setVideoOffset(event.currentTarget.valueAsNumber)}
        />
      </label>
      <label title="Frame of the clip at which the video begins">
        <span>Offset, frames</span>
        <input
          class="input"
          type="number"
          step="1"
          value={rounded(offset * clipRate, 2)}
          onChange={(event) => setVideoOffset(event.currentTarget.valueAsNumber / clipRate)}
        />
      </label>
      <label title="Seconds of the video per second of the clip; 4 for slow motion at a quarter of the speed">
        <span>Rate</span>
        <input
          class="input"
          type="number"
          min={videoRates.min}
          max={videoRates.max}
          step="any"
          value={rounded(rate, 5)}
          onChange={(event) => setVideoRate(event.currentTarget.valueAsNumber)}
        />
      </label>
    </div>
  );
}
