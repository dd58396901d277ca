import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { setDetectOptions } from "../actions/detect";
import { chooseEvidencePart, trackEvidence } from "../actions/evidence";
import { type ExplanationInput, explain } from "../model/explanation";
import { toSentence } from "../model/report";
import { sensitivity } from "../model/sensitivity";
import type { Clustering, Part, Side } from "../model/types";
import { evidence, evidencePart, pointedFrame } from "../store/evidence";
import { frame } from "../store/playback";
import { detectFailure, detection, edits } from "../store/session";
import { detectMethods, detectOptions } from "../store/settings";
import { SensitivitySlider, WindowSlider } from "../ui/DetectionSliders";
import { isAtKnee, normsFrame, runningVariance, sortedNorms, varianceFrame } from "./norm-curves";
import { Plot } from "./Plot";
import { scatter, scatterFrame } from "./scatter";

/** Why feet are taken for planted, and what other settings would make of them. */
export function EvidencePanel() {
  useEffect(trackEvidence, []);
  const input = useComputed<ExplanationInput | null>(() => {
    const tracks = evidence.value && detection.value?.parts[evidence.value.part];
    return evidence.value && tracks
      ? { evidence: evidence.value, tracks, edits: edits.value }
      : null;
  });
  const lastInput = useLast(input);
  const clustering = useLast(useComputed(() => input.value?.evidence.clustering ?? null));
  if (!input.value) {
    const reason = detectFailure.value?.message;
    return <p class="note">{reason ? toSentence(reason) : "Looking for the reasons…"}</p>;
  }
  return (
    <div class="evidence">
      <Parts />
      <Reading found={lastInput} />
      <Scatter found={lastInput} />
      {input.value.evidence.clustering && <Curves found={lastInput} clustering={clustering} />}
    </div>
  );
}

/** The last thing that there was: what shows it may be told of the next thing before it is gone. */
function useLast<T>(now: ReadonlySignal<T | null>): ReadonlySignal<T> {
  const last = useRef<T | null>(null);
  return useComputed(() => {
    last.current = now.value ?? last.current;
    return last.current as T;
  });
}

function Parts() {
  const parts = Object.keys(detection.value?.parts ?? {}) as Part[];
  if (parts.length < 2) return null;
  return (
    <fieldset class="segmented parts">
      <legend class="visually-hidden">Part</legend>
      {parts.map((part) => (
        <button
          key={part}
          type="button"
          aria-pressed={part === evidencePart.value}
          onClick={() => chooseEvidencePart(part)}
        >
          {part.charAt(0).toUpperCase() + part.slice(1)}
        </button>
      ))}
    </fieldset>
  );
}

const atNow = () => pointedFrame.value?.frame ?? frame.value;

/** Both feet at the playhead, or at the frame pointed at, in words. */
function Reading({ found }: { found: ReadonlySignal<ExplanationInput> }) {
  const at = useComputed(atNow);
  return (
    <div class="field frame-status" data-pointed={pointedFrame.value !== null}>
      <h2>Frame {at}</h2>
      <dl>
        <Foot found={found} side="left" />
        <Foot found={found} side="right" />
      </dl>
    </div>
  );
}

function Foot({ found, side }: { found: ReadonlySignal<ExplanationInput>; side: Side }) {
  const { label, reason } = explain(found.value, side, atNow());
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

/** What a screen reader is told of the frame, in every plot. */
function useText(found: ReadonlySignal<ExplanationInput>) {
  return useComputed(() => {
    const at = atNow();
    const feet = (["left", "right"] as const).map((side) => {
      const { label, reason } = explain(found.value, side, at);
      return `${label}: ${reason}`;
    });
    return `Frame ${at}. ${feet.join(". ")}`;
  });
}

function Scatter({ found }: { found: ReadonlySignal<ExplanationInput> }) {
  const picture = useComputed(() => scatter(found.value.tracks, found.value.evidence));
  const text = useText(found);
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
      <Plot frame={scatterFrame} picture={picture} text={text} />
      <p class="note">{scatterNote(found.value)}</p>
    </div>
  );
}

function scatterNote({ evidence: { thresholds, clustering } }: ExplanationInput): string {
  const title =
    detectMethods.value.find(({ name }) => name === detectOptions.value.method)?.title ?? "";
  if (clustering && !Number.isFinite(clustering.threshold))
    return "All frames are alike: nothing parts them.";
  if (clustering?.field) {
    return "Green: √degree at its threshold, for a foot that holds this height and speed. 1 is a typical planted frame.";
  }
  if (clustering) {
    return `${title} parts frames by a value of their own, u, which has no line in this plane.`;
  }
  if (thresholds.height !== undefined || thresholds.speed !== undefined) {
    return "The green lines are the thresholds that are set. This method clusters nothing, so it has no σ and no r.";
  }
  return detection.value?.notices.length && methodFamily() === "spectral"
    ? "Nothing was clustered here: the report says why."
    : `${title} clusters no graph, so there is no spectral evidence: no σ, no r and no boundary to draw.`;
}

const methodFamily = () =>
  detectMethods.value.find(({ name }) => name === detectOptions.value.method)?.family;

function Curves({
  found,
  clustering,
}: {
  found: ReadonlySignal<ExplanationInput>;
  clustering: ReadonlySignal<Clustering>;
}) {
  const norms = useComputed(() => sortedNorms(clustering.value));
  const variance = useComputed(() => runningVariance(clustering.value, dragR));
  const text = useText(found);
  const { sigma, knee, count } = clustering.value;
  const share = Math.round((100 * knee) / Math.max(count - 1, 1));
  const atKnee = isAtKnee(clustering.value);
  return (
    <>
      <div class="field">
        <div class="field-head">
          <h2>Running variance</h2>
          <output class="accent">knee {share} %</output>
        </div>
        <Plot frame={varianceFrame} picture={variance} text={text} />
        <p class="note">
          {atKnee
            ? "Of the norms below, up to each one. The knee is the last within r: drag the line or use the slider."
            : "Of the norms below, up to each one. This method does not look for the knee."}
        </p>
      </div>
      <div class="field">
        <div class="field-head">
          <h2>Sorted norms</h2>
          <output class="accent">σ {sigma.toFixed(3)}</output>
        </div>
        <Plot frame={normsFrame} picture={norms} text={text} />
        <p class="note">
          {atKnee
            ? "How far each sample is from standing still, in order. σ is the one at the knee."
            : "How far each sample is from standing still, in order. σ is the method’s own."}
        </p>
      </div>
      {atKnee && <SensitivitySlider />}
      <WindowSlider />
    </>
  );
}

function dragR(to: number) {
  const { min, max } = sensitivity;
  setDetectOptions({ r: Number(Math.min(Math.max(to, min), max).toFixed(4)) });
}
