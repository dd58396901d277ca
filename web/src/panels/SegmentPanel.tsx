import { useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { removeReferenceSegments } from "../actions/compare";
import { exportClips, exportSegments } from "../actions/export";
import { loopSegment } from "../actions/playback";
import { setSegmentName, setSegmentOptions } from "../actions/segment";
import { toSentence } from "../model/report";
import { type NamedSegment, segmentKind } from "../model/segments";
import { frame, loopedSegment } from "../store/playback";
import {
  cutScores,
  namedSegments,
  openClip,
  referenceSegments,
  renamedSegment,
  segmentation,
  segmentFailure,
} from "../store/session";
import { segmentMethods, segmentOptions } from "../store/settings";
import { Icon } from "../ui/icons";
import { ListHead } from "../ui/ListHead";
import { VirtualList } from "../ui/VirtualList";
import { formatCount } from "../util/format";

/** The actions that a clip is made of: how they are found, what they are called, and saved as. */
export function SegmentPanel() {
  if (!openClip.value?.frames) return <p class="note">No motion, so nothing to cut.</p>;
  return (
    <div class="segmenting">
      <Method />
      <Options />
      <Notices />
      <Comparison />
      <Listed />
    </div>
  );
}

const chosenMethod = () =>
  segmentMethods.value.find(({ name }) => name === segmentOptions.value.method);

function Method() {
  return (
    <div class="field">
      <h2>
        <label for="segment-method">Method</label>
      </h2>
      <select
        id="segment-method"
        class="select"
        value={segmentOptions.value.method}
        aria-describedby="segment-method-line"
        onChange={(event) => setSegmentOptions({ method: event.currentTarget.value })}
      >
        {segmentMethods.value.map(({ name, title }) => (
          <option key={name} value={name} selected={name === segmentOptions.value.method}>
            {title}
          </option>
        ))}
      </select>
      <p class="note" id="segment-method-line">
        {chosenMethod()?.description}
      </p>
    </div>
  );
}

/** The options that matter to the method. */
function Options() {
  const method = chosenMethod();
  const asked = segmentOptions.value;
  const { dims, residual = "absolute", template = "mean", published = false } = asked;
  if (!method || (method.dims === undefined && !method.options.length)) return null;
  const byFrame = template !== "mean" && template !== "tpose";
  return (
    <div class="field rows">
      {method.dims !== undefined && (
        <label>
          <span>Dimensions d</span>
          <select
            class="select"
            value={String(dims ?? method.dims)}
            onChange={(event) =>
              setSegmentOptions({ ...asked, dims: Number(event.currentTarget.value) })
            }
          >
            {[1, 2, 3, 4, 5, 6, 8, 10].map((d) => (
              <option key={d} value={d} selected={d === (dims ?? method.dims)}>
                {d === method.dims ? `${d}, as usual` : d}
              </option>
            ))}
          </select>
        </label>
      )}
      {method.options.includes("residual") && (
        <label>
          <span>Residual</span>
          <select
            class="select"
            value={residual}
            onChange={(event) =>
              setSegmentOptions({
                ...asked,
                residual: event.currentTarget.value === "ratio" ? "ratio" : "absolute",
              })
            }
          >
            <option value="absolute">Absolute</option>
            <option value="ratio">Ratio: nearly constant</option>
          </select>
        </label>
      )}
      {method.options.includes("template") && (
        <label>
          <span>Template</span>
          <select
            class="select"
            value={template}
            onChange={(event) => {
              const { value } = event.currentTarget;
              const pose = value === "this" ? `${frame.value}` : value;
              setSegmentOptions({ ...asked, template: pose as typeof template });
            }}
          >
            <option value="mean">Mean pose</option>
            <option value="tpose">T-pose</option>
            {byFrame && (
              <option value={template} selected>
                Frame {formatCount(Number(template))}
              </option>
            )}
            <option value="this">This frame</option>
          </select>
        </label>
      )}
      {method.options.includes("published") && (
        <label class="check">
          <input
            type="checkbox"
            checked={published}
            onChange={(event) =>
              setSegmentOptions({ ...asked, published: event.currentTarget.checked })
            }
          />
          As published
        </label>
      )}
    </div>
  );
}

function Notices() {
  const failure = segmentFailure.value;
  const notices = segmentation.value?.notices ?? [];
  if (failure) {
    return (
      <div class="field" role="status">
        <h2>No segments</h2>
        <p>{toSentence(failure.message)}</p>
        {failure.hint && <p class="note">{failure.hint}</p>}
      </div>
    );
  }
  if (!notices.length) return null;
  return (
    <ul class="field notes">
      {notices.map((notice) => (
        <li key={notice.text} class="note">
          {notice.text}
        </li>
      ))}
    </ul>
  );
}

const percent = (share: number) => (100 * share).toFixed(0);

/** How our cuts agree with someone else's. */
function Comparison() {
  const theirs = referenceSegments.value;
  if (!theirs) return null;
  return (
    <div class="field">
      <h2 id="cut-scores">Cuts compared, %</h2>
      <p class="compared">
        <span>{theirs.name}</span>
        <button type="button" class="button" onClick={removeReferenceSegments}>
          Remove
        </button>
      </p>
      {cutScores.value.length > 0 && (
        <table class="numbers" aria-labelledby="cut-scores">
          <thead>
            <tr>
              <th scope="col" title="Cuts at most this far apart are the same">
                Within
              </th>
              <th scope="col" title="Share of our cuts that are theirs too">
                Precision
              </th>
              <th scope="col" title="Share of their cuts that are ours too">
                Recall
              </th>
              <th scope="col" title="Harmonic mean of both">
                F1
              </th>
            </tr>
          </thead>
          <tbody>
            {cutScores.value.map(({ within, precision, recall, f1 }) => (
              <tr key={within}>
                <th scope="row">± {within.toFixed(1)} s</th>
                <td>{percent(precision)}</td>
                <td>{percent(recall)}</td>
                <td>
                  <strong>{percent(f1)}</strong>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </div>
  );
}

function Listed() {
  const rate = openClip.value?.rate ?? 1;
  if (!namedSegments.value.length) return null;
  return (
    <div class="field">
      <ListHead title="Segments" count={namedSegments.value.length}>
        <Save />
      </ListHead>
      <p class="columns segment-columns" aria-hidden="true">
        <span>Start</span>
        <span>Length</span>
        <span>Name</span>
      </p>
      <VirtualList
        items={namedSegments.value}
        shown={renamedSegment.value ? renamedSegment.value.number - 1 : undefined}
        row={(action) => <Row key={action.start} action={action} rate={rate} />}
      />
      {!referenceSegments.value && (
        <p class="note">Drop segments as JSON or CSV to see them below these.</p>
      )}
    </div>
  );
}

const formats = [
  ["json", "Segments", "JSON"],
  ["csv", "Table", "CSV"],
  ["babel", "BABEL", "JSON"],
] as const;

function Save() {
  return (
    <>
      {formats.map(([format, name, kind]) => (
        <button key={format} type="button" class="button" onClick={() => exportSegments(format)}>
          {name} <span class="muted">{kind}</span>
        </button>
      ))}
      <button type="button" class="button" onClick={exportClips}>
        Clips <span class="muted">BVH, zip</span>
      </button>
    </>
  );
}

function Row({ action, rate }: { action: NamedSegment; rate: number }) {
  const { number, start, end, kind, label, name } = action;
  const field = useRef<HTMLInputElement>(null);
  const before = useRef(name);
  const now = useComputed(() => frame.value >= start && frame.value < end);
  const isAsked = renamedSegment.value?.start === start;
  useEffect(() => {
    if (!isAsked) return;
    renamedSegment.value = null;
    field.current?.focus();
    field.current?.select();
  }, [isAsked]);
  const seconds = (frames: number) => (frames / rate).toFixed(2);
  const words = [`segment ${number}`, segmentKind(action)].filter(Boolean).join(", ");
  return (
    <div class="segment" data-now={now.value} data-chosen={loopedSegment.value?.start === start}>
      <button
        type="button"
        aria-label={`Loop ${words}, from ${seconds(start)} s, ${seconds(end - start)} s long`}
        aria-pressed={loopedSegment.value?.start === start}
        title={segmentKind(action) || undefined}
        onClick={() => loopSegment(action)}
      >
        <span class="number">
          {number}
          {kind !== "action" && <Icon name={kind} />}
        </span>
        <span>{seconds(start)}</span>
        <span>{seconds(end - start)}</span>
      </button>
      <input
        ref={field}
        class="name"
        type="text"
        aria-label={`Name of segment ${number}`}
        placeholder={label ? `Motifs ${label}` : "Unnamed"}
        value={name}
        maxLength={200}
        autocomplete="off"
        onInput={(event) => setSegmentName(action, event.currentTarget.value)}
        onFocus={() => {
          before.current = name;
        }}
        onKeyDown={(event) => {
          if (event.key === "Escape") setSegmentName(action, before.current);
          if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
        }}
      />
    </div>
  );
}
