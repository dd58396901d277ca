import { useComputed } from "@preact/signals";
import { exportGait, printGaitReport } from "../actions/save/export-gait";
import { jumpTo } from "../actions/view/playback";
import type { Gait, GaitAction, Step } from "../model/types";
import { frame } from "../store/playback";
import { gait, gaitAction, gaitActions, measuredAction } from "../store/session";
import { gaitFormats } from "../store/settings";
import { FormatButton } from "../ui/FormatButton";
import { ListHead } from "../ui/ListHead";
import { PropertyList } from "../ui/PropertyList";
import { VirtualList } from "../ui/VirtualList";
import { formatNumber, formatRange } from "../util/format";
import { GaitCurves } from "./GaitCurves";

/** Displayed measures: name, title, unit, factor to that unit, decimals. */
const measures = [
  ["stance_percent", "Stance", "% of cycle", 1, 1],
  ["swing_percent", "Swing", "% of cycle", 1, 1],
  ["single_support_percent", "Single support", "%", 1, 1],
  ["double_support_percent", "Double support", "%", 1, 1],
  ["stance_s", "Stance time", "s", 1, 2],
  ["swing_s", "Swing time", "s", 1, 2],
  ["stride_time_s", "Stride time", "s", 1, 2],
  ["step_time_s", "Step time", "s", 1, 2],
  ["stride_length_m", "Stride length", "cm", 100, 0],
  ["step_length_m", "Step length", "cm", 100, 0],
  ["step_width_m", "Step width", "cm", 100, 0],
] as const;

/** Statistics of a measure over the clip. */
type Statistics = { mean: number; sd?: number; count: number } | undefined;

/** Gait of the clip or of one of its actions: measures, joint angles and steps. */
export function GaitSection() {
  const measured = gait.value;
  const hasChoice = gaitActions.value.length > 0 && (measured || measuredAction.value);
  if (!measured || (!measured.strides && !measuredAction.value)) return null;
  return (
    <>
      <div class="field gait">
        <div class="field-head">
          <h2 id="gait">Gait</h2>
          {measured.strides > 0 && (
            <button
              type="button"
              class="button"
              title="Open a printable page with figures, plots, steps and definitions; it compares the actions unless one is chosen"
              onClick={() => void printGaitReport()}
            >
              Report
            </button>
          )}
        </div>
        {hasChoice && <ActionSelect />}
        {measured.strides > 0 ? (
          <Measures measured={measured} />
        ) : (
          <p class="note">This action contains no complete stride.</p>
        )}
      </div>
      {measured.curves.length > 0 && <GaitCurves measured={measured} />}
      {measured.steps.length > 0 && <StepList steps={measured.steps} />}
    </>
  );
}

/** Chooses the action that is measured. */
function ActionSelect() {
  return (
    <select
      class="select"
      aria-label="Action whose gait is measured"
      value={measuredAction.value?.name ?? ""}
      onChange={(event) => {
        gaitAction.value = event.currentTarget.value || null;
      }}
    >
      <option value="">Whole clip</option>
      {gaitActions.value.map((action) => (
        <option key={action.name} value={action.name}>
          {actionTitle(action)}
        </option>
      ))}
    </select>
  );
}

/** Returns the title of an action with its frames: `A, frames 0–385 and 1 more`. */
function actionTitle({ name, frames }: GaitAction): string {
  const [start = 0, end = 0] = frames;
  const more = frames.length / 2 - 1;
  return `${name}, frames ${formatRange({ start, end })}${more > 0 ? ` and ${more} more` : ""}`;
}

function Measures({ measured }: { measured: Gait }) {
  const { strides, leftOut, cadence, speed, beltSpeed, sides, symmetry } = measured;
  const { doubleSupportShare: doubleSupport, flightShare: flight } = measured;
  const symmetryIndices = [
    ["stance", symmetry.stance],
    ["swing", symmetry.swing],
    ["step time", symmetry.stepTime],
    ["step length", symmetry.stepLength],
  ] as const;
  const facts = [
    ["Cadence", cadence && `${cadence.toFixed(0)} steps/min`],
    ["Speed", speed && `${speed.toFixed(2)} m/s`],
    ["Surface", beltSpeed ? `treadmill, ${beltSpeed.toFixed(2)} m/s` : "overground"],
    ["Strides left out", leftOutText(leftOut)],
    ["Double support", strideFraction(doubleSupport)],
    ["Flight", flight && flight.mean > 0.005 && strideFraction(flight)],
    ...symmetryIndices.map(
      ([name, index]) => [`Symmetry index, ${name}`, symmetryText(index)] as const,
    ),
  ] as const;
  return (
    <>
      <table class="data-table gait-table" aria-labelledby="gait">
        <thead>
          <tr>
            <th scope="col">
              {strides} {strides === 1 ? "stride" : "strides"}, mean ± sd
            </th>
            <th scope="col" class="left">
              Left
            </th>
            <th scope="col" class="right">
              Right
            </th>
          </tr>
        </thead>
        <tbody>
          {measures.map(([name, title, unit, factor, decimals]) => {
            const side = sides.find((other) => other.name === name);
            const text = (statistics: Statistics) => (
              <MeanSd statistics={statistics} factor={factor} decimals={decimals} />
            );
            return (
              <tr key={name}>
                <th scope="row">
                  {title} <small>{unit}</small>
                </th>
                <td>{text(side?.left)}</td>
                <td>{text(side?.right)}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
      <PropertyList properties={facts} />
    </>
  );
}

function MeanSd({
  statistics,
  factor,
  decimals,
}: {
  statistics: Statistics;
  factor: number;
  decimals: number;
}) {
  if (!statistics) return <>–</>;
  const { mean, sd } = statistics;
  return (
    <>
      {formatNumber(factor * mean, decimals)}
      {sd !== undefined && <small> ± {(factor * sd).toFixed(decimals)}</small>}
    </>
  );
}

/** Returns the numbers of strides that were left out, by reason. */
function leftOutText({ cutOff, missingEvent, pause, onTheSpot }: Gait["leftOut"]) {
  const reasons = [
    [cutOff, "cut off"],
    [missingEvent, "missing event"],
    [pause, "pause"],
    [onTheSpot, "on the spot"],
  ] as const;
  const parts = reasons.flatMap(([count, reason]) => (count ? `${count} ${reason}` : []));
  return parts.join(", ") || undefined;
}

const strideFraction = (statistics: Statistics) =>
  statistics && `${(100 * statistics.mean).toFixed(0)} % of a stride`;

/** Formats a symmetry index: `0 %`, or `right +16 %` for a longer right side. */
function symmetryText(index: number | undefined): string | undefined {
  if (index === undefined) return undefined;
  const percent = Math.round(index);
  if (percent === 0) return "0 %";
  return `right ${percent > 0 ? "+" : "−"}${Math.abs(percent)} %`;
}

/** The steps; a row moves the playhead to its foot strike. */
function StepList({ steps }: { steps: readonly Step[] }) {
  return (
    <div class="field">
      <ListHead title="Steps" count={steps.length}>
        {gaitFormats.value.map((format) => (
          <FormatButton key={format.name} format={format} onClick={() => void exportGait(format)} />
        ))}
      </ListHead>
      <p class="list-columns gait-columns" aria-hidden="true">
        <span>Strike s</span>
        <span>Time s</span>
        <span>Length cm</span>
        <span>Stance %</span>
      </p>
      <VirtualList
        items={steps}
        renderRow={(step) => (
          <StepRow
            key={`${step.side}${step.strikeFrame}`}
            step={step}
            end={
              steps.find(
                ({ side, strikeFrame }) => side === step.side && strikeFrame > step.strikeFrame,
              )?.strikeFrame ?? Number.POSITIVE_INFINITY
            }
          />
        )}
      />
    </div>
  );
}

/** A step; `end` is the next foot strike of the same foot. */
function StepRow({ step, end }: { step: Step; end: number }) {
  const { side, strikeFrame, strike, stepTime, stepLength, stride, leftOut } = step;
  const isCurrent = useComputed(() => frame.value >= strikeFrame && frame.value < end);
  const sideName = side === "left" ? "Left" : "Right";
  return (
    <button
      type="button"
      class={`plant gait-columns ${side}`}
      aria-current={isCurrent.value ? "true" : undefined}
      title={leftOut && `The stride is left out: ${leftOut}`}
      onClick={() => jumpTo(strikeFrame)}
    >
      <span class="side">
        <span class="dot" aria-hidden="true" />
        {sideName}
      </span>
      <Cell name="foot strike" text={strike.toFixed(2)} />
      <Cell name="step time" text={stepTime?.toFixed(2)} />
      <Cell name="step length" text={stepLength && formatNumber(100 * stepLength, 0)} />
      <Cell name="stance" text={stride?.stancePercent.toFixed(0)} />
    </button>
  );
}

/** A value of a step with its name for screen readers. */
function Cell({ name, text }: { name: string; text: string | undefined | 0 }) {
  return (
    <span>
      <span class="visually-hidden">, {name} </span>
      {text || "–"}
    </span>
  );
}
