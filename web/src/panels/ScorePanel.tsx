import { useComputed } from "@preact/signals";
import { removeReference } from "../actions/analyse/compare";
import { commandOf, tooltip } from "../actions/commands";
import { adoptReference } from "../actions/edit/edit";
import { jumpTo } from "../actions/view/playback";
import type { Disagreement, Score } from "../model/types";
import { frame, playing } from "../store/playback";
import { openClip, reference, score, scorePart, scores } from "../store/session";
import { PropertyList } from "../ui/PropertyList";
import { VirtualList } from "../ui/VirtualList";
import { capitalize } from "../util/format";

/** Agreement of the labels with a reference. */
export function ScorePanel() {
  const annotation = reference.value;
  if (!annotation) return null;
  const current = score.value;
  return (
    <>
      <div class="field">
        <h2>Compared with</h2>
        <p class="reference-name">
          <span>{annotation.name}</span>
          <button type="button" class="button" onClick={removeReference}>
            Remove
          </button>
        </p>
        <button type="button" class="button" onClick={adoptReference}>
          Use these labels
        </button>
      </div>
      {current ? (
        <>
          {scores.value.length > 1 && <PartChoice current={current} />}
          <Accuracy score={current} />
          <Events score={current} />
          <Disagreements score={current} />
        </>
      ) : (
        <p class="note">The labels and the reference have no part in common.</p>
      )}
    </>
  );
}

function PartChoice({ current }: { current: Score }) {
  return (
    <fieldset class="segmented full-width">
      <legend class="visually-hidden">Part</legend>
      {scores.value.map(({ part }) => (
        <button
          key={part}
          type="button"
          aria-pressed={part === current.part}
          onClick={() => {
            scorePart.value = part;
          }}
        >
          {capitalize(part)}
        </button>
      ))}
    </fieldset>
  );
}

const percent = (fraction: number) =>
  Number.isFinite(fraction) ? (100 * fraction).toFixed(1) : "–";

function Accuracy({ score: { rows } }: { score: Score }) {
  return (
    <div class="field">
      <h2 id="accuracy">Accuracy within tolerance, %</h2>
      <table class="data-table" aria-labelledby="accuracy">
        <thead>
          <tr>
            <th
              scope="col"
              title="Disagreements this close to a boundary of the reference are accepted"
            >
              Within
            </th>
            <th scope="col" title="Both feet; disagreements near a boundary are accepted">
              Both
            </th>
            <th scope="col">Left</th>
            <th scope="col">Right</th>
            <th
              scope="col"
              title="Boundaries may move by at most this much; then every frame counts"
            >
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

function Events({ score: { events } }: { score: Score }) {
  const facts = [
    ["Precision", `${percent(events.precision)} %`],
    ["Recall", `${percent(events.recall)} %`],
    ["F1", `${percent(events.f1)} %`],
    ["Foot strikes", delayText(events.onset)],
    ["Foot offs", delayText(events.offset)],
  ] as const;
  return (
    <div class="field">
      <h2>Plants</h2>
      <PropertyList properties={facts} />
    </div>
  );
}

/** Formats a median error: `12 ms late`. */
function delayText(seconds: number): string {
  const ms = Math.round(1000 * Math.abs(seconds));
  if (!Number.isFinite(seconds)) return "–";
  return ms === 0 ? "on time" : `${ms} ms ${seconds > 0 ? "late" : "early"}`;
}

function Disagreements({ score: { disagreements } }: { score: Score }) {
  const isAtPlayhead = (item: Disagreement) => frame.value >= item.start && frame.value < item.end;
  const current = useComputed(() => disagreements.findIndex(isAtPlayhead)).value;
  const rate = openClip.value?.rate ?? 1;
  return (
    <>
      <div class="list-head">
        <h2>Differences</h2>
        <p class="step-buttons">
          <span class="muted">{disagreements.length || "None"}</span>
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
        // During playback, the list would scroll the table of accuracies away.
        visibleIndex={playing.value || current < 0 ? undefined : current}
        renderRow={(item) => (
          <DisagreementRow key={`${item.side} ${item.start}`} disagreement={item} rate={rate} />
        )}
      />
    </>
  );
}

function DisagreementRow({
  disagreement: { side, kind, start, end },
  rate,
}: {
  disagreement: Disagreement;
  rate: number;
}) {
  const isCurrent = useComputed(() => frame.value >= start && frame.value < end);
  const frames = end - start;
  return (
    <button
      type="button"
      class={`plant disagreement ${side}`}
      aria-current={isCurrent.value ? "true" : undefined}
      onClick={() => jumpTo(start)}
    >
      <span class="side">
        <span class="dot" aria-hidden="true" />
        {side === "left" ? "Left" : "Right"}
      </span>
      <span class="kind">{kind === "missed" ? "False negative" : "False positive"}</span>
      <span>{(start / rate).toFixed(2)}</span>
      <span>
        {frames} {frames === 1 ? "frame" : "frames"}
      </span>
    </button>
  );
}
