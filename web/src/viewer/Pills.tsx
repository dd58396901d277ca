import { useComputed } from "@preact/signals";
import { type Plant, plantAt } from "../model/plants";
import type { Side } from "../model/types";
import { isFramePreviewed, shownFrame } from "../store/evidence";
import { detection, openClip, plants } from "../store/session";
import { formatDuration } from "../util/format";

/** Contact state of each foot at the shown frame, as text. */
export function Pills() {
  if (!detection.value) return null;
  return (
    <div class="pills">
      {isFramePreviewed.value && <p class="pill frame-pill">Frame {shownFrame}</p>}
      <Pill side="left" />
      <Pill side="right" />
    </div>
  );
}

function Pill({ side }: { side: Side }) {
  const current = useComputed<Plant | undefined>(() =>
    plantAt(plants.value, shownFrame.value, side),
  );
  const name = side === "left" ? "Left" : "Right";
  const rate = openClip.value?.rate ?? 1;
  const plant = current.value;
  return (
    <p class={`pill ${side}`} data-planted={plant !== undefined}>
      <span class="dot" aria-hidden="true" />
      {plant ? (
        <>
          {name} planted{" "}
          <span class="muted">{formatDuration((plant.end - plant.start) / rate)}</span>
        </>
      ) : (
        `${name} in the air`
      )}
    </p>
  );
}
