import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { percentOfCycle, valueAtPercent } from "../model/motion/gait-cycle";
import type { AngleCurve, Gait, Side } from "../model/types";
import { playhead } from "../store/playback";
import { openClip } from "../store/session";
import { formatNumber } from "../util/format";
import { createGaitPlot, type Percents } from "./gait-plot";

const titles: Record<string, string> = {
  hip_flexion: "Hip flexion",
  knee_flexion: "Knee flexion",
  ankle_dorsiflexion: "Ankle dorsiflexion",
};

/** Joint angles over the gait cycle, left and right, with markers at the playhead. */
export function GaitCurves({ measured }: { measured: Gait }) {
  const percents = useComputed<Percents>(() => {
    const time = playhead.value / (openClip.value?.rate ?? 1);
    const percent = (side: Side) => percentOfCycle(measured.steps, side, time);
    return { left: percent("left"), right: percent("right") };
  });
  return (
    <div class="field gait-curves">
      <div class="field-head">
        <h2>Joint angles</h2>
        <CyclePosition percents={percents} />
      </div>
      {measured.curves.map((curve) => (
        <CurvePlot key={curve.name} curve={curve} percents={percents} />
      ))}
      <p class="note">
        Mean and standard deviation over the gait cycle in percent, left solid, right dashed. Angles
        between lines through joint centres in the plane of travel; these are not clinical angles.
      </p>
    </div>
  );
}

/** The position of the playhead in the gait cycle of each foot. */
function CyclePosition({ percents }: { percents: ReadonlySignal<Percents> }) {
  const text = (percent: number | undefined) =>
    percent === undefined ? "–" : `${Math.floor(percent)} %`;
  return (
    <p class="plot-legend cycle-position">
      <span class="left">
        <i class="dot" aria-hidden="true" /> L {text(percents.value.left)}
      </span>
      <span class="right">
        <i class="dot" aria-hidden="true" /> R {text(percents.value.right)}
      </span>
    </p>
  );
}

function CurvePlot({ curve, percents }: { curve: AngleCurve; percents: ReadonlySignal<Percents> }) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(
    () => (host.current ? createGaitPlot(host.current, curve, percents) : undefined),
    [curve, percents],
  );
  const title = titles[curve.name] ?? curve.name;
  return (
    <figure>
      <figcaption>
        {title} <CurrentAngles curve={curve} percents={percents} />
      </figcaption>
      <div ref={host} class="plot gait-plot" role="img" aria-label={description(title, curve)} />
    </figure>
  );
}

/** The angles at the playhead by the mean curves. */
function CurrentAngles({
  curve,
  percents,
}: {
  curve: AngleCurve;
  percents: ReadonlySignal<Percents>;
}) {
  const text = (side: Side) => {
    const percent = percents.value[side];
    const angle = percent === undefined ? undefined : valueAtPercent(curve[side]?.mean, percent);
    return angle === undefined ? "–" : degrees(angle);
  };
  return (
    <span class="muted">
      L {text("left")} · R {text("right")}
    </span>
  );
}

/** Describes a plot: `Knee flexion: left 3° to 64°, right 2° to 63°`. */
function description(title: string, curve: AngleCurve): string {
  const range = (side: Side) => {
    const mean = curve[side]?.mean;
    return mean && `${side} ${degrees(Math.min(...mean))} to ${degrees(Math.max(...mean))}`;
  };
  const ranges = [range("left"), range("right")].filter(Boolean);
  return `${title} over the gait cycle: ${ranges.join(", ")}`;
}

const degrees = (angle: number) => `${formatNumber(angle, 0)}°`;
