import { computed, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { exportAll, rerunBatch, resumeBatch, stopBatch } from "../actions/batch";
import { columns, filterRows, sortRows } from "../model/table";
import { batchRequest, batchRows, finishedCount, tableVisible } from "../store/batch";
import { openClip } from "../store/session";
import { detectMethods, detectOptions } from "../store/settings";
import { Icon } from "../ui/icons";
import { Rows } from "./Rows";

const words = signal("");
const order = signal<{ key: string; direction: 1 | -1 }>({ key: "", direction: 1 });

const listed = computed(() =>
  sortRows(filterRows(batchRows.value, words.value), order.value.key, order.value.direction),
);

/** All clips of a drop in one table that fills as they are labelled. */
export function Batch() {
  const box = useRef<HTMLElement>(null);
  useEffect(() => box.current?.focus(), []);
  return (
    <section class="batch" aria-labelledby="batch-title" ref={box} tabIndex={-1}>
      <Head />
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable by keyboard */}
      <div class="batch-scroll" data-scrolls tabIndex={0}>
        <table aria-rowcount={listed.value.length + 1} aria-labelledby="batch-title">
          <ColumnHeads />
          <Rows rows={listed.value} />
        </table>
      </div>
    </section>
  );
}

function Head() {
  const all = batchRows.value.length;
  const done = finishedCount.value;
  const isRunning = batchRows.value.some(({ status }) => status === "running");
  const isStopped = done < all && !isRunning;
  const method = detectMethods.value.find(({ name }) => name === batchRequest.value?.detect.method);
  const back = openClip.value ? `Back to ${openClip.value.name}` : "Back to the start";
  const isStale = batchRequest.value?.detect !== detectOptions.value;
  return (
    <div class="batch-head">
      <h2 id="batch-title">{all} clips</h2>
      <p class="muted" aria-live="off">
        {done < all ? `${done} labelled` : "All labelled"}
        {method && ` by ${method.title}`}
      </p>
      {done < all && <progress aria-label="Clips labelled" value={done} max={all} />}
      {isRunning && (
        <button type="button" class="button" onClick={stopBatch}>
          Stop
        </button>
      )}
      {isStopped && (
        <button type="button" class="button" onClick={resumeBatch}>
          Go on
        </button>
      )}
      {!isRunning && !isStopped && isStale && (
        <button type="button" class="button" onClick={rerunBatch}>
          Label again
        </button>
      )}
      <span class="spacer" />
      <input
        class="input"
        type="search"
        aria-label="Filter by name"
        placeholder="Filter"
        value={words.value}
        onInput={(event) => {
          words.value = event.currentTarget.value;
        }}
      />
      <button type="button" class="button" disabled={done === 0} onClick={exportAll}>
        Save all <span class="muted">zip</span>
      </button>
      <button
        type="button"
        class="button icon-only"
        aria-label={back}
        title={back}
        onClick={() => {
          tableVisible.value = false;
        }}
      >
        <Icon name="close" />
      </button>
    </div>
  );
}

function ColumnHeads() {
  const { key, direction } = order.value;
  return (
    <thead>
      <tr aria-rowindex={1}>
        {columns.map((column) => (
          <th
            key={column.key}
            scope="col"
            data-minor={column.minor}
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
              {column.title}
              {key === column.key && <Icon name={direction > 0 ? "less" : "more"} />}
            </button>
          </th>
        ))}
      </tr>
    </thead>
  );
}
