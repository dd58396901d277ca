/** Processing many clips: detection and segmentation in parallel, shown in one table. */

import { batch, computed } from "@preact/signals";
import * as Comlink from "comlink";
import { batchWorkers } from "../../engine";
import type { BatchRequest, ClipSummary } from "../../model/batch/batch";
import { failureOf } from "../../model/failure";
import { fileTooLarge, maxFileBytes } from "../../model/limits";
import { type Source, titleOfSource } from "../../model/sources/source";
import {
  type BatchRow,
  batchRequest,
  batchRows,
  focusedRow,
  isBatchRunning,
  openBatchRow,
  tableFilter,
  tableNumber,
  tableVisible,
} from "../../store/batch";
import { type ErrorReport, errorReport, reportOpenFailure } from "../../store/errors";
import { edits, plants, segmentNames } from "../../store/session";
import { detectOptions, segmentOptions } from "../../store/settings";
import { announce, dialog, notify } from "../../store/view";
import { addTableEntry, leaveTableEntry, replaceTable } from "../open/history";
import { openSource } from "../open/open";
import { readChecked, writeChecked } from "../stored/clip-storage";
import { storedChangesOf } from "../stored/persist";
import { pause, seekPlant } from "../view/playback";
import { compareQuietly } from "./compare";

/** Aborted when the batch is stopped. */
let controller = new AbortController();

/** Processes clips; files that could not be unpacked appear in the table as failed. */
export async function runBatch(clips: readonly Source[], errors: readonly ErrorReport[]) {
  stopBatch();
  const failed = errors.map(({ name, failure }) => ({
    source: { name, data: new Blob() },
    status: "failed" as const,
    // There is no file to process again.
    failure: { ...failure, canRetry: false },
  }));
  const waiting = clips.map((source) => ({ source, status: "waiting" as const }));
  batch(() => {
    pause();
    errorReport.value = null;
    batchRows.value = [...waiting, ...failed].map((row, i) => ({ ...row, number: i + 1 }));
    batchRequest.value = currentRequest();
    tableFilter.value = "";
    tableNumber.value++;
    tableVisible.value = true;
  });
  addTableEntry();
  await resumeBatch();
}

const currentRequest = () => ({ detect: detectOptions.value, segment: segmentOptions.value });

/** Returns the options with which the batch was started, so that all rows have the same. */
const requestOfTable = () => batchRequest.peek() ?? currentRequest();

/** Processes the waiting clips, unless a run does so already. */
export async function resumeBatch() {
  if (isBatchRunning.value) return;
  isBatchRunning.value = true;
  const { signal } = controller;
  const request = { ...requestOfTable(), save: false };
  const waiting = batchRows.value.filter(({ status }) => status === "waiting");
  await Promise.all(waiting.map((row) => summarizeRow(row, request, signal)));
  if (signal.aborted) return;
  flushUpdates();
  await nameActions(signal);
  if (signal.aborted) return;
  isBatchRunning.value = false;
  const failed = batchRows.value.filter(({ status }) => status === "failed").length;
  announce(
    `${batchRows.value.length} files processed${failed ? `, ${failed} could not be read` : ""}`,
  );
}

/** Gives equal actions of all clips equal letters. */
async function nameActions(signal: AbortSignal) {
  const clips = batchRows.value.map(({ summary }) => summary?.actions);
  try {
    const actions = await batchWorkers.run((calls) => calls.commonActions(clips), signal);
    batchRows.value = batchRows.value.map((row, i) => ({ ...row, actions: actions[i] }));
  } catch (error) {
    if (!signal.aborted)
      notify(`The actions of the clips could not be matched: ${failureOf(error).message}`);
  }
}

/** Processes all clips again, with the current options. */
export async function rerunBatch() {
  stopBatch();
  batchRequest.value = currentRequest();
  batchRows.value = batchRows.value.map(({ number, source, ...row }) =>
    row.status === "done" ? { number, source, status: "waiting" } : { number, source, ...row },
  );
  await resumeBatch();
}

/** Processes the clips again on which the program failed, with the options of the others. */
export async function retryFailed() {
  batchRows.value = batchRows.value.map(({ number, source, ...row }) =>
    row.failure?.canRetry ? { number, source, status: "waiting" } : { number, source, ...row },
  );
  await resumeBatch();
}

async function summarizeRow(row: BatchRow, request: BatchRequest, signal: AbortSignal) {
  const { name, data, lenient = false } = row.source;
  if (data.size > maxFileBytes) {
    updateRow(row, { status: "failed", failure: fileTooLarge(data.size) });
    return;
  }
  try {
    let hash = "";
    const changesOf = (hashOfFile: string) => {
      hash = hashOfFile;
      return storedChangesOf(hash);
    };
    const result = await batchWorkers.run((calls) => {
      // A processed clip retains its results until there are new ones.
      if (row.status !== "done") updateRow(row, { status: "running" });
      // Read here, because labels may be added while the row waits.
      const references = row.source.labels?.map((label) => label.data) ?? [];
      const rowRequest = { ...request, lenient };
      return calls.summarize(data, name, rowRequest, references, Comlink.proxy(changesOf));
    }, signal);
    if (signal.aborted) return;
    updateRow(
      row,
      result.ok
        ? {
            status: "done",
            summary: withNotices(result.summary, row.source),
            ...(hash && { hash }),
            ...(hash && readChecked(hash) === checkedText(request) && { isChecked: true }),
          }
        : { status: "failed", failure: result.failure },
    );
  } catch (error) {
    if (signal.aborted) return;
    updateRow(row, { status: "failed", failure: failureOf(error) });
  }
}

/** Adds the notices of the source, which the worker does not know. */
const withNotices = (summary: ClipSummary, { notices = [] }: Source): ClipSummary => ({
  ...summary,
  notices: summary.notices + notices.length,
});

/** Pending updates; they are collected because rendering the table takes processor time from the workers. */
const updates = new Map<number, Partial<BatchRow>>();

/** Time between two updates of the table, in milliseconds. */
const updateInterval = 200;

function updateRow({ number }: BatchRow, update: Partial<BatchRow>) {
  if (!updates.size) setTimeout(flushUpdates, updateInterval);
  updates.set(number, { ...updates.get(number), ...update });
}

/** Shows the pending updates. */
export function flushUpdates() {
  if (!updates.size) return;
  batchRows.value = batchRows.value.map((row) => {
    const update = updates.get(row.number);
    const { failure: _, ...others } = row;
    return update ? { ...others, ...update } : row;
  });
  updates.clear();
}

/** Stops running rows; they wait until the batch is resumed. */
export function stopBatch() {
  controller.abort(new Error("stopped"));
  controller = new AbortController();
  isBatchRunning.value = false;
  flushUpdates();
  batchRows.value = batchRows.value.map((row) =>
    row.status === "running" ? { ...row, status: "waiting" } : row,
  );
}

/** Processes the open clip again if it has edits, which may be newer than its row. */
export async function refreshOpenRow(): Promise<void> {
  const row = openBatchRow.value;
  const hasChanges = edits.value.length > 0 || segmentNames.value.length > 0;
  const { edited = false, actions } = row?.summary ?? {};
  if (row?.status !== "done" || !(edited || actions?.names.size || hasChanges)) return;
  await processAgain(row);
}

/** Processes one row again, with the options of the others. */
export async function processAgain(row: BatchRow): Promise<void> {
  await summarizeRow(row, { ...requestOfTable(), save: false }, controller.signal);
  flushUpdates();
}

/** Shows the table. */
export function showTable() {
  pause();
  batch(() => {
    dialog.value = null;
    tableVisible.value = true;
  });
  addTableEntry();
  void refreshOpenRow();
}

/** Hides the table. */
export function hideTable() {
  tableVisible.value = false;
  leaveTableEntry();
}

/** Opens a clip of the table. Returns true if it is the open one at the end. */
export async function openRow({ source, failure }: BatchRow): Promise<boolean> {
  if (failure && !source.data.size) {
    // Failed before there was a file.
    reportOpenFailure(titleOfSource(source), failure);
    return false;
  }
  void refreshOpenRow();
  const showClip = replaceTable();
  const whenOpen = async () => {
    showClip();
    const row = openBatchRow.value;
    await Promise.all([compareQuietly(source), row?.status === "failed" && readAgain(row)]);
  };
  return openSource(source, { whenOpen });
}

/** Processes a row again that could not be read until its clip was opened in another way. */
async function readAgain(row: BatchRow) {
  const { signal } = controller;
  await processAgain(row);
  if (!isBatchRunning.value && !signal.aborted) await nameActions(signal);
}

/** Returns the clips that wait for a review, the least certain first. */
const reviewQueue = () =>
  batchRows.value
    .filter(({ status, isChecked }) => status === "done" && !isChecked)
    .toSorted((a, b) => (a.summary?.confidence ?? 0) - (b.summary?.confidence ?? 0));

/** Number of clips that are not marked as checked. */
export const uncheckedCount = computed(() => reviewQueue().length);

/** Opens the clip that needs a review most, other than the open one. */
export async function reviewNext(): Promise<void> {
  const next = reviewQueue().find((row) => row !== openBatchRow.value);
  if (next) {
    if (await openRow(next)) goToLeastCertain();
  } else notify("All other clips are checked");
}

/** Goes to the plant of the lowest confidence. */
function goToLeastCertain() {
  const [first, ...others] = plants.value.filter(({ edited }) => !edited);
  if (!first) return;
  pause();
  seekPlant(others.reduce((a, b) => (b.confidence < a.confidence ? b : a), first));
}

/** Returns the stored mark of a checked clip: it holds only for labels of the same options. */
const checkedText = ({ detect }: Pick<BatchRequest, "detect">) => JSON.stringify(detect);

/** The row that a key marks as checked: that of the open clip, or in the table the one that has the focus. */
export const rowToMark = computed(() =>
  tableVisible.value
    ? batchRows.value.find(({ number, summary }) => summary && number === focusedRow.value)
    : openBatchRow.value,
);

/** Marks a clip as checked, or removes the mark. */
export function toggleChecked(row = rowToMark.value) {
  const request = batchRequest.peek();
  if (!row || !request) return;
  if (row.hash) writeChecked(row.hash, row.isChecked ? null : checkedText(request));
  batchRows.value = batchRows.value.map((other) =>
    other.number === row.number ? { ...other, isChecked: !other.isChecked } : other,
  );
}
