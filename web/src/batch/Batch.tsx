import { computed, signal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import {
  hideTable,
  rerunBatch,
  resumeBatch,
  retryFailed,
  stopBatch,
  uncheckedCount,
} from "../actions/analyse/batch";
import { addDroppedLabels } from "../actions/analyse/row-labels";
import { commandOf, tooltip } from "../actions/commands";
import { exportAll } from "../actions/save/export-batch";
import { columns, filterRows, haveSameOptions, sortRows } from "../model/batch/table";
import {
  batchRequest,
  batchRows,
  finishedCount,
  focusedRow,
  isBatchRunning,
  savesTable,
  tableFilter,
} from "../store/batch";
import { clipTitle, openClip } from "../store/session";
import { detectMethods, detectOptions, segmentOptions } from "../store/settings";
import { Icon } from "../ui/icons";
import { formatCount, plural } from "../util/format";
import { Rows } from "./Rows";

const order = signal<{ key: string; direction: 1 | -1 }>({ key: "", direction: 1 });

const visibleRows = computed(() =>
  sortRows(filterRows(batchRows.value, tableFilter.value), order.value.key, order.value.direction),
);

/** The table of all clips that were dropped together, updated while they are processed. */
export function Batch() {
  const section = useRef<HTMLElement>(null);
  useEffect(() => section.current?.focus(), []);
  useSignalEffect(addDroppedLabels);
  useSignalEffect(() => {
    if (!savesTable.value) return;
    savesTable.value = false;
    void exportAll();
  });
  return (
    <section
      class="batch"
      aria-labelledby="batch-title"
      ref={section}
      tabIndex={-1}
      onFocusIn={followFocus}
      onFocusOut={() => {
        focusedRow.value = undefined;
      }}
    >
      <Toolbar />
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a scroll container must be focusable by keyboard */}
      <div class="batch-scroll" data-scrolls tabIndex={0}>
        <table aria-rowcount={visibleRows.value.length + 1} aria-labelledby="batch-title">
          <ColumnHeaders />
          <Rows rows={visibleRows.value} />
        </table>
      </div>
    </section>
  );
}

/** Notes the row that has the focus, which keys mark. */
function followFocus({ target }: FocusEvent) {
  const row = target instanceof Element && target.closest<HTMLElement>("tr[data-number]");
  focusedRow.value = row ? Number(row.dataset.number) : undefined;
}

function Toolbar() {
  const total = batchRows.value.length;
  const done = finishedCount.value;
  const isRunning = done < total && isBatchRunning.value;
  const failed = batchRows.value.filter(({ status }) => status === "failed").length;
  const shown = visibleRows.value.length;
  const isStopped = done < total && !isRunning;
  const method = detectMethods.value.find(({ name }) => name === batchRequest.value?.detect.method);
  const closeLabel = `Back to ${openClip.value ? clipTitle : "the start page"}`;
  const options = { detect: detectOptions.value, segment: segmentOptions.value };
  const isStale = !haveSameOptions(batchRequest.value ?? options, options);
  return (
    <div class="batch-head">
      <h2 id="batch-title">
        {shown < total ? `${shown} of ${plural(total, "clip")}` : plural(total, "clip")}
      </h2>
      <p class="muted" aria-live="off">
        {done < total ? `${done} processed` : "All processed"}
        {failed > 0 && `, ${failed} failed`}
        {method && ` · ${method.title}`}
      </p>
      {done < total && <progress aria-label="Processed clips" value={done} max={total} />}
      {isRunning && (
        <button type="button" class="button" onClick={stopBatch}>
          Stop
        </button>
      )}
      {isStopped && (
        <button type="button" class="button" onClick={resumeBatch}>
          Resume
        </button>
      )}
      {!isRunning && batchRows.value.some(({ failure }) => failure?.canRetry) && (
        <button type="button" class="button" onClick={retryFailed}>
          Try failed files again
        </button>
      )}
      {!isRunning && isStale && (
        <button type="button" class="button" onClick={rerunBatch}>
          Process again
        </button>
      )}
      <span class="spacer" />
      {done > 0 && (
        <button
          type="button"
          class="button"
          disabled={uncheckedCount.value === 0}
          title={tooltip("review-next", "Open the least certain clip that is not checked")}
          onClick={commandOf("review-next").run}
        >
          Review <span class="muted">{formatCount(uncheckedCount.value)}</span>
        </button>
      )}
      <input
        class="input"
        type="search"
        aria-label="Filter by name"
        placeholder="Filter: name, failed, unchecked"
        value={tableFilter.value}
        onInput={(event) => {
          tableFilter.value = event.currentTarget.value;
        }}
      />
      <button type="button" class="button" disabled={done === 0} onClick={exportAll}>
        Save all <span class="muted">zip</span>
      </button>
      <button
        type="button"
        class="button icon-only"
        aria-label={closeLabel}
        title={closeLabel}
        onClick={hideTable}
      >
        <Icon name="close" />
      </button>
    </div>
  );
}

function ColumnHeaders() {
  const { key, direction } = order.value;
  return (
    <thead>
      <tr aria-rowindex={1}>
        {columns.map((column) => (
          <th
            key={column.key}
            scope="col"
            data-minor={column.minor}
            data-key={column.key}
            aria-sort={key !== column.key ? "none" : direction > 0 ? "ascending" : "descending"}
          >
            <button
              type="button"
              title={column.description}
              onClick={() => {
                order.value = {
                  key: column.key,
                  direction: key === column.key && direction > 0 ? -1 : 1,
                };
              }}
            >
              <span>
                {column.title}
                {column.detail && <small> {column.detail}</small>}
              </span>
              {key === column.key && <Icon name={direction > 0 ? "collapse" : "expand"} />}
            </button>
          </th>
        ))}
      </tr>
    </thead>
  );
}
