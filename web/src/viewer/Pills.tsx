import { useComputed } from "@preact/signals";
import { type Plant, plantAt } from "../model/plants";
import type { Side } from "../model/types";
import { isFramePreviewed, shownFrame } from "../store/evidence";
import { detection, openClip, plants } from "../store/session";
import { formatDuration } from "../util/format";

/** What each foot does now, in words. */
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
  const plant = useComputed<Plant | undefined>(() => plantAt(plants.value, shownFrame.value, side));
  const name = side === "left" ? "Left" : "Right";
  const rate = openClip.value?.rate ?? 1;
  const planted = plant.value;
  return (
    <p class={`pill ${side}`} data-planted={planted !== undefined}>
      <span class="dot" aria-hidden="true" />
      {planted ? (
        <>
          {name} planted{" "}
          <span class="muted">{formatDuration((planted.end - planted.start) / rate)}</span>
        </>
      ) : (
        `${name} in the air`
      )}
    </p>
  );
}
