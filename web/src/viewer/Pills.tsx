import { useComputed } from "@preact/signals";
import { detection, frame, openClip, plants } from "../app/state";
import { type Plant, plantAt } from "../lib/plants";
import { span } from "../lib/time";
import type { Side } from "../worker/types";

/** What each foot does now, in words. */
export function Pills() {
  if (!detection.value) return null;
  return (
    <div class="pills">
      <Pill side="left" />
      <Pill side="right" />
    </div>
  );
}

function Pill({ side }: { side: Side }) {
  const plant = useComputed<Plant | undefined>(() => plantAt(plants.value, frame.value, side));
  const name = side === "left" ? "Left" : "Right";
  const rate = openClip.value?.rate ?? 1;
  const planted = plant.value;
  return (
    <p class={`pill ${side}`} data-planted={planted !== undefined}>
      <span class="dot" aria-hidden="true" />
      {planted ? (
        <>
          {name} planted <span class="quiet">{span((planted.end - planted.start) / rate)}</span>
        </>
      ) : (
        `${name} in the air`
      )}
    </p>
  );
}
