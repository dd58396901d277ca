import { type ReadonlySignal, useComputed } from "@preact/signals";
import { commandOf, keyOf, tooltip } from "../actions/commands";
import { speeds } from "../actions/view/playback";
import { matchingRange } from "../model/segments/segments";
import {
  direction,
  frame,
  loop,
  loopedRange,
  loopedSegment,
  loopRegion,
  playing,
  speed,
} from "../store/playback";
import { openClip, plants } from "../store/session";
import { Icon } from "../ui/icons";
import { formatClock, formatCount, formatRange } from "../util/format";
import type { Layout } from "./layout";
import { SimilarOffer } from "./SimilarOffer";
import { TracksMenu } from "./TracksMenu";

/** Playback controls, with the time and the frame of the playhead. */
export function Transport({ layout }: { layout: ReadonlySignal<Layout> }) {
  const { frames = 0, rate = 1 } = openClip.value ?? {};
  const timeText = useComputed(() => formatClock(frame.value / (openClip.value?.rate ?? 1)));
  const frameText = useComputed(() => formatCount(frame.value));
  const isStill = frames < 2;
  return (
    <div class="transport">
      <div class="transport-part">
        <button
          type="button"
          class="play"
          disabled={isStill}
          aria-label={playing.value ? "Pause" : "Play"}
          title={tooltip("play", playing.value ? "Pause" : "Play")}
          onClick={commandOf("play").run}
        >
          <Icon name={playing.value ? "pause" : "play"} />
        </button>
        <div class="position">
          <p class="clock" title={`Duration ${formatClock(frames / rate)}`}>
            {timeText}
          </p>
          <p class="frame-count" title="The first frame is 0">
            <span class="muted">frame</span> {frameText}{" "}
            <span class="muted">/ {formatCount(Math.max(0, frames - 1))}</span>
          </p>
        </div>
        {direction.value < 0 && playing.value && <p class="muted">reverse</p>}
      </div>
      <SimilarOffer />
      <div class="transport-part">
        <button
          type="button"
          class="button flat loop"
          aria-pressed={loop.value !== "off"}
          data-is-part={loopedRange.value !== null}
          title={tooltip("loop")}
          onClick={commandOf("loop").run}
          disabled={isStill}
        >
          <Icon name="loop" />
          <LoopLabel />
        </button>
        <label>
          <span class="visually-hidden">Speed</span>
          <select
            class="select small"
            title={`Speed (${keyOf("slower")} and ${keyOf("faster")})`}
            value={String(speed.value)}
            disabled={isStill}
            onChange={(event) => {
              speed.value = Number(event.currentTarget.value);
            }}
          >
            {speeds.map((factor) => (
              <option key={factor} value={String(factor)}>
                {factor}×
              </option>
            ))}
          </select>
        </label>
        <TracksMenu layout={layout} />
        <button
          type="button"
          class="button fit"
          title={tooltip("fit")}
          onClick={commandOf("fit").run}
          disabled={isStill}
        >
          Fit
        </button>
      </div>
    </div>
  );
}

/** The looped range, as the label of the loop button. */
function LoopLabel() {
  if (loop.value === "off") return <span>Loop off</span>;
  if (loop.value === "clip") return <span>Loop clip</span>;
  if (loop.value === "segment") return <span>Loop segment {loopedSegment.value?.number}</span>;
  if (loop.value === "range")
    return <span>Loop {loopRegion.value && formatRange(loopRegion.value)}</span>;
  // An edit may have moved its edges.
  const plant = loopRegion.value && matchingRange(plants.value, loopRegion.value);
  return <span>Loop plant {plant?.number}</span>;
}
