import { useComputed } from "@preact/signals";
import { type Plant, plantAt } from "../model/plants/plants";
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
  const elapsed = useComputed(() => {
    const start = current.value?.start ?? 0;
    return ((shownFrame.value - start) / (openClip.value?.rate ?? 1)).toFixed(2);
  });
  return (
    <p class={`pill ${side}`} data-planted={plant !== undefined}>
      <span class="dot" aria-hidden="true" />
      {plant ? (
        <>
          {name} in contact{" "}
          <span class="muted">
            {elapsed} of {formatDuration((plant.end - plant.start) / rate)}
          </span>
        </>
      ) : (
        `${name} in the air`
      )}
    </p>
  );
}
