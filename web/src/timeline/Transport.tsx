import { useComputed } from "@preact/signals";
import { commandOf, keyOf, tooltip } from "../actions/commands";
import { speeds } from "../actions/playback";
import { frame, loop, loopedSegment, loopRegion, playing, speed } from "../store/playback";
import { openClip, plants } from "../store/session";
import { Icon } from "../ui/icons";
import { formatClock, formatCount } from "../util/format";

export function Transport() {
  const held = openClip.value;
  const rate = held?.rate ?? 1;
  const time = useComputed(() => formatClock(frame.value / (openClip.value?.rate ?? 1)));
  const number = useComputed(() => formatCount(frame.value));
  const still = (held?.frames ?? 0) < 2;
  return (
    <div class="transport">
      <button
        type="button"
        class="play"
        disabled={still}
        aria-label={playing.value ? "Pause" : "Play"}
        title={tooltip("play", playing.value ? "Pause" : "Play")}
        onClick={commandOf("play").run}
      >
        <Icon name={playing.value ? "pause" : "play"} />
      </button>
      <p class="clock" title={`${formatClock((held?.frames ?? 0) / rate)} in all`}>
        {time}
      </p>
      <p class="frame-count">
        <span class="muted">frame</span> {number}{" "}
        <span class="muted">/ {formatCount(held?.frames ?? 0)}</span>
      </p>
      <span class="spacer" />
      <button
        type="button"
        class="button flat loop"
        aria-pressed={loop.value !== "off"}
        title={tooltip("loop")}
        onClick={commandOf("loop").run}
        disabled={still}
      >
        <Icon name="loop" />
        <LoopName />
      </button>
      <label class="speed">
        <span class="visually-hidden">Speed</span>
        <select
          class="select small"
          title={`Speed (${keyOf("slower")} and ${keyOf("faster")})`}
          value={String(speed.value)}
          disabled={still}
          onChange={(event) => {
            speed.value = Number(event.currentTarget.value);
          }}
        >
          {speeds.map((s) => (
            <option key={s} value={String(s)}>
              {s}×
            </option>
          ))}
        </select>
      </label>
      <button
        type="button"
        class="button fit"
        title={tooltip("fit")}
        onClick={commandOf("fit").run}
        disabled={still}
      >
        Fit
      </button>
    </div>
  );
}

function LoopName() {
  if (loop.value === "off") return <span>Loop off</span>;
  if (loop.value === "clip") return <span>Loop clip</span>;
  if (loop.value === "segment") return <span>Loop segment {loopedSegment.value?.number}</span>;
  const plant = plants.value.find((p) => p.start === loopRegion.value?.start);
  return <span>Loop plant {plant?.number}</span>;
}
