import { useComputed } from "@preact/signals";
import { commandOf, tooltip } from "../actions/commands";
import { removeReference } from "../actions/compare";
import { adoptReference } from "../actions/edit";
import { pause, seek } from "../actions/playback";
import type { Disagreement, Score } from "../model/types";
import { frame } from "../store/playback";
import { openClip, reference, score, scorePart, scores } from "../store/session";
import { Facts } from "../ui/Facts";
import { VirtualList } from "../ui/VirtualList";

/** How our labels agree with someone else's. */
export function ScorePanel() {
  const theirs = reference.value;
  if (!theirs) return null;
  const shown = score.value;
  return (
    <div class="score">
      <div class="field">
        <h2>Compared with</h2>
        <p class="compared">
          <span>{theirs.name}</span>
          <button type="button" class="button" onClick={removeReference}>
            Remove
          </button>
        </p>
        <button type="button" class="button" onClick={adoptReference}>
          Make these labels mine
        </button>
      </div>
      {shown ? (
        <>
          {scores.value.length > 1 && <Parts shown={shown} />}
          <Accuracy of={shown} />
          <Events of={shown} />
          <Disagreements of={shown} />
        </>
      ) : (
        <p class="note">No part is labelled on both sides, so there is nothing to compare.</p>
      )}
    </div>
  );
}

function Parts({ shown }: { shown: Score }) {
  return (
    <fieldset class="segmented parts">
      <legend class="visually-hidden">Part</legend>
      {scores.value.map(({ part }) => (
        <button
          key={part}
          type="button"
          aria-pressed={part === shown.part}
          onClick={() => {
            scorePart.value = part;
          }}
        >
          {part.charAt(0).toUpperCase() + part.slice(1)}
        </button>
      ))}
    </fieldset>
  );
}

const percent = (share: number) => (Number.isFinite(share) ? (100 * share).toFixed(1) : "–");

function Accuracy({ of: { rows } }: { of: Score }) {
  return (
    <div class="field">
      <h2 id="accuracy">Frames that agree, %</h2>
      <table class="numbers" aria-labelledby="accuracy">
        <thead>
          <tr>
            <th scope="col" title="Labels this close to a boundary count as right">
              Within
            </th>
            <th scope="col" title="Both feet; labels near a boundary are right">
              Both
            </th>
            <th scope="col">Left</th>
            <th scope="col">Right</th>
            <th scope="col" title="Boundaries move at most that far, then every frame counts">
              Strict
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map(({ fuzzy, lenient, left, right, strict }) => (
            <tr key={fuzzy}>
              <th scope="row">{fuzzy.toFixed(1)} s</th>
              <td>
                <strong>{percent(lenient)}</strong>
              </td>
              <td>{percent(left)}</td>
              <td>{percent(right)}</td>
              <td>{percent(strict)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Events({ of: { events } }: { of: Score }) {
  const facts = [
    ["Precision", `${percent(events.precision)} %`],
    ["Recall", `${percent(events.recall)} %`],
    ["F1", `${percent(events.f1)} %`],
    ["Beginnings", late(events.onset)],
    ["Ends", late(events.offset)],
  ] as const;
  return (
    <div class="field">
      <h2>Plants</h2>
      <Facts facts={facts} />
    </div>
  );
}

/** A median error in words: `12 ms late`. */
function late(seconds: number): string {
  const ms = Math.round(1000 * Math.abs(seconds));
  if (!Number.isFinite(seconds)) return "–";
  return ms === 0 ? "on time" : `${ms} ms ${seconds > 0 ? "late" : "early"}`;
}

function Disagreements({ of: { disagreements } }: { of: Score }) {
  const rate = openClip.value?.rate ?? 1;
  return (
    <div class="differences">
      <div class="list-head">
        <h2>Differences</h2>
        <p class="steps">
          <span class="muted">{disagreements.length || "none"}</span>
          {disagreements.length > 0 && (
            <>
              <button
                type="button"
                class="button"
                title={tooltip("previous-difference")}
                aria-label="Previous difference"
                onClick={commandOf("previous-difference").run}
              >
                ←
              </button>
              <button
                type="button"
                class="button"
                title={tooltip("next-difference")}
                aria-label="Next difference"
                onClick={commandOf("next-difference").run}
              >
                →
              </button>
            </>
          )}
        </p>
      </div>
      <VirtualList
        items={disagreements}
        row={(item) => <Difference key={`${item.side} ${item.start}`} of={item} rate={rate} />}
      />
    </div>
  );
}

function Difference({ of: run, rate }: { of: Disagreement; rate: number }) {
  const now = useComputed(() => frame.value >= run.start && frame.value < run.end);
  const go = () => {
    pause();
    seek(run.start);
  };
  const frames = run.end - run.start;
  return (
    <button
      type="button"
      class={`plant difference ${run.side}`}
      aria-current={now.value ? "true" : undefined}
      onClick={go}
    >
      <span class="side">
        <span class="dot" aria-hidden="true" />
        {run.side === "left" ? "Left" : "Right"}
      </span>
      <span class="kind">{run.kind === "missed" ? "Missed" : "Too much"}</span>
      <span>{(run.start / rate).toFixed(2)}</span>
      <span>
        {frames} {frames === 1 ? "frame" : "frames"}
      </span>
    </button>
  );
}
