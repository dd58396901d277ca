import { useComputed } from "@preact/signals";
import { useEffect, useId, useRef } from "preact/hooks";
import { removeReferenceSegments } from "../actions/analyse/compare";
import { runSegmentation, setSegmentName, setSegmentOptions } from "../actions/analyse/segment";
import { commandOf, tooltip } from "../actions/commands";
import { moveCutTo } from "../actions/edit/edit-cuts";
import { exportClips, exportSegments } from "../actions/save/export-segments";
import { loopSegment } from "../actions/view/playback";
import { toSentence } from "../model/batch/report";
import {
  actionText,
  type NamedSegment,
  type SegmentName,
  segmentKind,
} from "../model/segments/segments";
import type { SegmentOptions } from "../model/types";
import { openVocabulary } from "../store/batch";
import { frame, loopedSegment } from "../store/playback";
import {
  cutScores,
  namedSegments,
  openClip,
  referenceSegments,
  renamedSegment,
  segmentation,
  segmentFailure,
  segmentNames,
  selectedCut,
} from "../store/session";
import { segmentFormats, segmentMethods, segmentOptions } from "../store/settings";
import { CommandButton } from "../ui/CommandButton";
import { FormatButton } from "../ui/FormatButton";
import { Icon } from "../ui/icons";
import { ListHead } from "../ui/ListHead";
import { OpenOrDrop } from "../ui/OpenOrDrop";
import { CutStepper } from "../ui/Stepper";
import { VirtualList } from "../ui/VirtualList";
import { formatCount } from "../util/format";

/** Segmentation method, its options, comparison, and the list of segments. */
export function SegmentPanel() {
  if (!openClip.value?.frames) return <p class="note">This clip has no motion to segment.</p>;
  return (
    <div class="segment-panel">
      <Method />
      <Options />
      <Notices />
      <Comparison />
      <CutEditor />
      <SegmentList />
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

/** The options that the method uses. */
function Options() {
  const method = chosenMethod();
  const options = segmentOptions.value;
  const { dims, residual = "absolute", template = "mean", published = false } = options;
  if (!method || (method.dims === undefined && !method.options.length)) return null;
  const isFrameTemplate = template !== "mean" && template !== "tpose";
  return (
    <div class="field form-rows">
      {method.dims !== undefined && (
        <label>
          <span>Dimensions d</span>
          <select
            class="select"
            value={String(dims ?? method.dims)}
            onChange={(event) =>
              setSegmentOptions({ ...options, dims: Number(event.currentTarget.value) })
            }
          >
            {[1, 2, 3, 4, 5, 6, 8, 10].map((d) => (
              <option key={d} value={d} selected={d === (dims ?? method.dims)}>
                {d === method.dims ? `${d} (default)` : d}
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
                ...options,
                residual: event.currentTarget.value === "ratio" ? "ratio" : "absolute",
              })
            }
          >
            <option value="absolute">Absolute</option>
            <option value="ratio">Ratio (nearly constant)</option>
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
              const template = value === "this" ? `${frame.value}` : value;
              setSegmentOptions({
                ...options,
                template: template as NonNullable<SegmentOptions["template"]>,
              });
            }}
          >
            <option value="mean">Mean pose</option>
            <option value="tpose">T-pose</option>
            {isFrameTemplate && (
              <option value={template} selected>
                Frame {formatCount(Number(template))}
              </option>
            )}
            <option value="this">Current frame</option>
          </select>
        </label>
      )}
      {method.options.includes("published") && (
        <label class="checkbox-row">
          <input
            type="checkbox"
            checked={published}
            onChange={(event) =>
              setSegmentOptions({ ...options, published: event.currentTarget.checked })
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
        {failure.canRetry && (
          <button type="button" class="button" onClick={() => void runSegmentation()}>
            Try again
          </button>
        )}
      </div>
    );
  }
  if (!notices.length) return null;
  return (
    <ul class="field note-list">
      {notices.map((notice) => (
        <li key={notice.text} class="note">
          {notice.text}
        </li>
      ))}
    </ul>
  );
}

const percent = (fraction: number) => (100 * fraction).toFixed(0);

/** Agreement of the cuts with a reference. */
function Comparison() {
  const annotation = referenceSegments.value;
  if (!annotation) return null;
  return (
    <div class="field">
      <h2 id="cut-scores">Agreement of cuts, %</h2>
      <p class="reference-name">
        <span>{annotation.name}</span>
        <button type="button" class="button" onClick={removeReferenceSegments}>
          Remove
        </button>
      </p>
      {cutScores.value.length > 0 && (
        <table class="data-table" aria-labelledby="cut-scores">
          <thead>
            <tr>
              <th scope="col" title="Cuts at most this far apart are matched">
                Within
              </th>
              <th scope="col" title="Percentage of detected cuts that match the reference">
                Precision
              </th>
              <th scope="col" title="Percentage of reference cuts that were detected">
                Recall
              </th>
              <th scope="col" title="Harmonic mean of precision and recall">
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

/** Buttons and a field for all edits of cuts, as an alternative to dragging. */
function CutEditor() {
  const id = useId();
  if (!namedSegments.value.length) return null;
  const cut = selectedCut.value;
  return (
    <div class="field">
      <div class="field-head">
        <h2>Cuts</h2>
        <CommandButton id="undo" />
        <CommandButton id="redo" />
      </div>
      {cut === null ? (
        <p class="note">Select a cut in the timeline to move it.</p>
      ) : (
        <div class="frame-field">
          <label for={id}>Cut at frame</label>
          <CutStepper>
            <input
              id={id}
              class="input"
              type="number"
              min={1}
              step={1}
              value={cut}
              onChange={async (event) => {
                const field = event.currentTarget;
                const to = field.valueAsNumber;
                if (Number.isInteger(to)) await moveCutTo(cut, to);
                // Invalid input is replaced by the frame of the cut.
                field.value = String(selectedCut.value ?? cut);
              }}
            />
          </CutStepper>
        </div>
      )}
      <p class="cut-buttons">
        <button
          type="button"
          class="button"
          title={tooltip("add-cut")}
          onClick={commandOf("add-cut").run}
        >
          Add cut
        </button>
        <button
          type="button"
          class="button"
          title={tooltip("remove-cut", cut === null ? "Remove the nearest cut" : "Remove cut")}
          onClick={commandOf("remove-cut").run}
        >
          {cut === null ? "Remove nearest cut" : "Remove cut"}
        </button>
      </p>
    </div>
  );
}

function SegmentList() {
  const rate = openClip.value?.rate ?? 1;
  if (!namedSegments.value.length) return null;
  return (
    <div class="field">
      <ListHead title="Segments" count={namedSegments.value.length}>
        <SaveButtons />
      </ListHead>
      {openVocabulary.value && (
        <p class="note">The same action has the same letter and name in all clips of the table.</p>
      )}
      <p class="list-columns segment-columns" aria-hidden="true">
        <span>Start</span>
        <span>Length</span>
        <span>Name</span>
      </p>
      <VirtualList
        items={namedSegments.value}
        visibleIndex={renamedSegment.value ? renamedSegment.value.number - 1 : undefined}
        scrollsAtFirst
        renderRow={(segment) => <Row key={segment.start} segment={segment} rate={rate} />}
      />
      {!referenceSegments.value && (
        <p class="note">
          <OpenOrDrop /> a segment file (JSON or CSV) to compare it with these segments.
        </p>
      )}
    </div>
  );
}

function SaveButtons() {
  return (
    <>
      {segmentFormats.value.map((format) => (
        <FormatButton key={format.name} format={format} onClick={() => exportSegments(format)} />
      ))}
      <button type="button" class="button" onClick={exportClips}>
        Clips <span class="muted">BVH, zip</span>
      </button>
    </>
  );
}

function Row({ segment, rate }: { segment: NamedSegment; rate: number }) {
  const { number, start, end, kind, label, name, action } = segment;
  const field = useRef<HTMLInputElement>(null);
  /** The names before the user typed one; null until then. */
  const previousNames = useRef<readonly SegmentName[] | null>(null);
  const isCurrent = useComputed(() => frame.value >= start && frame.value < end);
  const isRenamed = renamedSegment.value?.start === start;
  useEffect(() => {
    if (!isRenamed) return;
    renamedSegment.value = null;
    field.current?.focus();
    field.current?.select();
  }, [isRenamed]);
  const seconds = (frames: number) => (frames / rate).toFixed(2);
  const details = [action && `action ${actionText(segment)}`, segmentKind(segment)];
  const spoken = [
    `Loop segment ${number}`,
    `from ${seconds(start)} s`,
    `${seconds(end - start)} s long`,
    ...details,
  ].filter(Boolean);
  return (
    <div
      class="segment"
      data-current={isCurrent.value}
      data-looped={loopedSegment.value?.start === start}
    >
      <button
        type="button"
        aria-label={spoken.join(", ")}
        aria-pressed={loopedSegment.value?.start === start}
        title={details.filter(Boolean).join(", ") || undefined}
        onClick={() => loopSegment(segment)}
      >
        <span class="number">
          {number}
          {action && <span class="action-letter">{action}</span>}
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
        onInput={(event) => {
          previousNames.current ??= segmentNames.value;
          setSegmentName(segment, event.currentTarget.value);
        }}
        onBlur={() => {
          previousNames.current = null;
        }}
        onKeyDown={(event) => {
          if (event.key === "Escape" && previousNames.current)
            segmentNames.value = previousNames.current;
          if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
        }}
      />
    </div>
  );
}
