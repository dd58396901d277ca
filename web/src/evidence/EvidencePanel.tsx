import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { setDetectOptions } from "../actions/analyse/detect";
import { chooseEvidencePart, trackEvidence } from "../actions/analyse/evidence";
import { toSentence } from "../model/batch/report";
import { type ExplanationInput, explain } from "../model/plants/explanation";
import { sensitivity } from "../model/plants/sensitivity";
import type { Clustering, Part, Side } from "../model/types";
import { evidence, evidencePart, pointedFrame } from "../store/evidence";
import { frame } from "../store/playback";
import { detectFailure, detection, plantEdits } from "../store/session";
import { detectMethods, detectOptions } from "../store/settings";
import { SensitivitySlider, WindowSlider } from "../ui/DetectionSliders";
import { capitalize } from "../util/format";
import {
  isSigmaAtKnee,
  normsSpec,
  runningVariancePlot,
  sortedNormsPlot,
  varianceSpec,
} from "./norm-curves";
import { Plot } from "./Plot";
import { scatterPlot, scatterSpec } from "./scatter";

/** Evidence for the labels: the state of both feet in a frame, plots, and the detection settings. */
export function EvidencePanel() {
  useEffect(trackEvidence, []);
  const input = useComputed<ExplanationInput | null>(() => {
    const tracks = evidence.value && detection.value?.parts[evidence.value.part];
    return evidence.value && tracks
      ? { evidence: evidence.value, tracks, edits: plantEdits.value }
      : null;
  });
  const lastInput = useLastValue(input);
  const clustering = useLastValue(useComputed(() => input.value?.evidence.clustering ?? null));
  if (!input.value) {
    const reason = detectFailure.value?.message;
    return <p class="note">{reason ? toSentence(reason) : "Loading evidence…"}</p>;
  }
  return (
    <div class="evidence">
      <PartSwitch />
      <FrameStatus input={lastInput} />
      <ScatterSection input={lastInput} />
      {input.value.evidence.clustering && (
        <NormSections input={lastInput} clustering={clustering} />
      )}
    </div>
  );
}

/** Returns the last value that was not null: components may render once more after it is cleared. */
function useLastValue<T>(current: ReadonlySignal<T | null>): ReadonlySignal<T> {
  const last = useRef<T | null>(null);
  return useComputed(() => {
    last.current = current.value ?? last.current;
    return last.current as T;
  });
}

/** Buttons that choose the explained part of the foot. */
function PartSwitch() {
  const parts = Object.keys(detection.value?.parts ?? {}) as Part[];
  if (parts.length < 2) return null;
  return (
    <fieldset class="segmented full-width">
      <legend class="visually-hidden">Part</legend>
      {parts.map((part) => (
        <button
          key={part}
          type="button"
          aria-pressed={part === evidencePart.value}
          onClick={() => chooseEvidencePart(part)}
        >
          {capitalize(part)}
        </button>
      ))}
    </fieldset>
  );
}

/** Returns the pointed frame, or the frame at the playhead. */
const shownFrame = () => pointedFrame.value?.frame ?? frame.value;

/** The state of both feet in the shown frame, as text. */
function FrameStatus({ input }: { input: ReadonlySignal<ExplanationInput> }) {
  const shown = useComputed(shownFrame);
  return (
    <div class="field frame-status" data-pointed={pointedFrame.value !== null}>
      <h2>Frame {shown}</h2>
      <dl>
        <FootStatus input={input} side="left" />
        <FootStatus input={input} side="right" />
      </dl>
    </div>
  );
}

function FootStatus({ input, side }: { input: ReadonlySignal<ExplanationInput>; side: Side }) {
  const { label, reason } = explain(input.value, side, shownFrame());
  return (
    <div class={side}>
      <dt>
        <span class="dot" aria-hidden="true" />
        {label}
      </dt>
      <dd>{reason}</dd>
    </div>
  );
}

/** Returns the description of the shown frame for screen readers. */
function useDescription(input: ReadonlySignal<ExplanationInput>) {
  return useComputed(() => {
    const shown = shownFrame();
    const feet = (["left", "right"] as const).map((side) => {
      const { label, reason } = explain(input.value, side, shown);
      return `${label}: ${reason}`;
    });
    return `Frame ${shown}. ${feet.join(". ")}`;
  });
}

function ScatterSection({ input }: { input: ReadonlySignal<ExplanationInput> }) {
  const plotData = useComputed(() => scatterPlot(input.value.tracks, input.value.evidence));
  const text = useDescription(input);
  return (
    <div class="field">
      <div class="field-head">
        <h2>Height and speed</h2>
        <p class="plot-legend" aria-hidden="true">
          <span class="left">
            <i class="dot" /> L
          </span>
          <span class="right">
            <i class="dot" /> R planted
          </span>
          <span class="swing">
            <i class="dot" /> air
          </span>
        </p>
      </div>
      <Plot spec={scatterSpec} plotData={plotData} text={text} />
      <p class="note">{scatterNote(input.value)}</p>
    </div>
  );
}

/** Returns the explanation of the lines in the scatter plot. */
function scatterNote({ evidence: { thresholds, clustering } }: ExplanationInput): string {
  const title =
    detectMethods.value.find(({ name }) => name === detectOptions.value.method)?.title ?? "";
  if (clustering && !Number.isFinite(clustering.threshold))
    return "All frames are equal, so there is no decision boundary.";
  if (clustering?.field) {
    return "Green line: decision boundary, where √degree equals the threshold for a foot at constant height and speed. A typical planted frame has √degree 1.";
  }
  if (clustering) {
    return `${title} classifies frames by a value u that does not depend on height and speed alone, so no boundary is drawn.`;
  }
  if (thresholds.height !== undefined || thresholds.speed !== undefined) {
    return "Green lines: thresholds. This method does not use clustering, so it has no σ and no r.";
  }
  return detection.value?.notices.length && methodFamily() === "spectral"
    ? "The frames were not clustered. See the report for the reason."
    : `${title} is not a spectral method, so it has no σ, no r and no decision boundary.`;
}

/** Returns the family of the chosen detection method. */
const methodFamily = () =>
  detectMethods.value.find(({ name }) => name === detectOptions.value.method)?.family;

/** The plots of the norms and their running variance, with the sliders for r and w. */
function NormSections({
  input,
  clustering,
}: {
  input: ReadonlySignal<ExplanationInput>;
  clustering: ReadonlySignal<Clustering>;
}) {
  const norms = useComputed(() => sortedNormsPlot(clustering.value));
  const variance = useComputed(() => runningVariancePlot(clustering.value, setSensitivity));
  const text = useDescription(input);
  const { sigma, sigmaIsLimited, knee, count } = clustering.value;
  const percent = Math.round((100 * knee) / Math.max(count - 1, 1));
  const hasKnee = isSigmaAtKnee(clustering.value);
  return (
    <>
      <div class="field">
        <div class="field-head">
          <h2>Running variance</h2>
          <output class="accent">knee {percent} %</output>
        </div>
        <Plot spec={varianceSpec} plotData={variance} text={text} />
        <p class="note">
          {hasKnee
            ? "Variance of the sorted norms up to each rank. The knee is the last rank within r. Drag the line or use the slider to change r."
            : "Variance of the sorted norms up to each rank. This method does not use the knee."}
        </p>
      </div>
      <div class="field">
        <div class="field-head">
          <h2>Sorted norms</h2>
          <output class="accent">σ {sigma.toFixed(3)}</output>
        </div>
        <Plot spec={normsSpec} plotData={norms} text={text} />
        <p class="note">
          {hasKnee
            ? `Distance of each sample from rest, in ascending order. σ is the norm at the knee${sigmaIsLimited ? ", limited to speeds of planted feet" : ""}.`
            : "Distance of each sample from rest, in ascending order. This method determines σ in another way."}
        </p>
      </div>
      {hasKnee && <SensitivitySlider />}
      <WindowSlider />
    </>
  );
}

function setSensitivity(r: number) {
  const { min, max } = sensitivity;
  setDetectOptions({ r: Number(Math.min(Math.max(r, min), max).toPrecision(3)) });
}
