import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { setOptions } from "../app/detect";
import { detectFailure, detection, edits, frame, methods, options } from "../app/state";
import { explain, followWhy, pointed, why, whyPart } from "../app/why";
import { sensitivity } from "../lib/logSlider";
import { sentence } from "../lib/report";
import { type Case, verdict } from "../lib/verdict";
import { isAtKnee, normsFrame, runningVariance, sortedNorms, varianceFrame } from "../why/curves";
import { Plot } from "../why/Plot";
import { scatter, scatterFrame } from "../why/scatter";
import type { Evidence, Part, Side } from "../worker/types";
import { Sensitivity, Window } from "./Sensitivity";

/** Why feet are taken for planted, and what other settings would make of them. */
export function WhyPanel() {
  useEffect(followWhy, []);
  const found = useComputed<Case | null>(() => {
    const tracks = why.value && detection.value?.parts[why.value.part];
    return why.value && tracks ? { why: why.value, tracks, edits: edits.value } : null;
  });
  const held = useLast(found);
  const evidence = useLast(useComputed(() => found.value?.why.evidence ?? null));
  if (!found.value) {
    const reason = detectFailure.value?.message;
    return <p class="note">{reason ? sentence(reason) : "Looking for the reasons…"}</p>;
  }
  return (
    <div class="why-panel">
      <Parts />
      <Reading found={held} />
      <Scatter found={held} />
      {found.value.why.evidence && <Curves found={held} evidence={evidence} />}
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
      <legend class="hidden">Part</legend>
      {parts.map((part) => (
        <button
          key={part}
          type="button"
          aria-pressed={part === whyPart.value}
          onClick={() => explain(part)}
        >
          {part.charAt(0).toUpperCase() + part.slice(1)}
        </button>
      ))}
    </fieldset>
  );
}

const atNow = () => pointed.value?.frame ?? frame.value;

/** Both feet at the playhead, or at the frame pointed at, in words. */
function Reading({ found }: { found: ReadonlySignal<Case> }) {
  const at = useComputed(atNow);
  return (
    <div class="field reading" data-pointed={pointed.value !== null}>
      <h2>Frame {at}</h2>
      <dl>
        <Foot found={found} side="left" />
        <Foot found={found} side="right" />
      </dl>
    </div>
  );
}

function Foot({ found, side }: { found: ReadonlySignal<Case>; side: Side }) {
  const { label, reason } = verdict(found.value, side, atNow());
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
function useText(found: ReadonlySignal<Case>) {
  return useComputed(() => {
    const at = atNow();
    const feet = (["left", "right"] as const).map((side) => {
      const { label, reason } = verdict(found.value, side, at);
      return `${label}: ${reason}`;
    });
    return `Frame ${at}. ${feet.join(". ")}`;
  });
}

function Scatter({ found }: { found: ReadonlySignal<Case> }) {
  const picture = useComputed(() => scatter(found.value.tracks, found.value.why));
  const text = useText(found);
  return (
    <div class="field">
      <div class="field-head">
        <h2>Height and speed</h2>
        <p class="why-key" aria-hidden="true">
          <span class="left">
            <i class="dot" /> L
          </span>
          <span class="right">
            <i class="dot" /> R planted
          </span>
          <span class="air">
            <i class="dot" /> air
          </span>
        </p>
      </div>
      <Plot frame={scatterFrame} picture={picture} text={text} />
      <p class="note">{scatterNote(found.value)}</p>
    </div>
  );
}

function scatterNote({ why: { limits, evidence } }: Case): string {
  const title = methods.value.find(({ name }) => name === options.value.method)?.title ?? "";
  if (evidence && !Number.isFinite(evidence.threshold))
    return "All frames are alike: nothing parts them.";
  if (evidence?.field) {
    return "Green: √degree at its threshold, for a foot that holds this height and speed. 1 is a typical planted frame.";
  }
  if (evidence) {
    return `${title} parts frames by a value of their own, u, which has no line in this plane.`;
  }
  if (limits.height !== undefined || limits.speed !== undefined) {
    return "The green lines are the thresholds that are set. This method clusters nothing, so it has no σ and no r.";
  }
  return detection.value?.notices.length && whyFamily() === "spectral"
    ? "Nothing was clustered here: the report says why."
    : `${title} clusters no graph, so there is no spectral evidence: no σ, no r and no boundary to draw.`;
}

const whyFamily = () => methods.value.find(({ name }) => name === options.value.method)?.family;

function Curves({
  found,
  evidence,
}: {
  found: ReadonlySignal<Case>;
  evidence: ReadonlySignal<Evidence>;
}) {
  const norms = useComputed(() => sortedNorms(evidence.value));
  const variance = useComputed(() => runningVariance(evidence.value, dragR));
  const text = useText(found);
  const { sigma, knee, count } = evidence.value;
  const share = Math.round((100 * knee) / Math.max(count - 1, 1));
  const atKnee = isAtKnee(evidence.value);
  return (
    <>
      <div class="field">
        <div class="field-head">
          <h2>Running variance</h2>
          <output class="green">knee {share} %</output>
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
          <output class="green">σ {sigma.toFixed(3)}</output>
        </div>
        <Plot frame={normsFrame} picture={norms} text={text} />
        <p class="note">
          {atKnee
            ? "How far each sample is from standing still, in order. σ is the one at the knee."
            : "How far each sample is from standing still, in order. σ is the method’s own."}
        </p>
      </div>
      {atKnee && <Sensitivity />}
      <Window />
    </>
  );
}

function dragR(to: number) {
  const { min, max } = sensitivity;
  setOptions({ r: Number(Math.min(Math.max(to, min), max).toFixed(4)) });
}
