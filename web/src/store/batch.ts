/** The table of many clips. */

import { computed, signal } from "@preact/signals";
import type { BatchRequest, ClipSummary } from "../model/batch/batch";
import { namesOfActions, type Vocabulary } from "../model/segments/segments";
import type { Source } from "../model/sources/source";
import { keyOfHash } from "../model/stored/stored-changes";
import type { Failure } from "../model/types";
import { session } from "./clip-session";

/** One file of the table. */
export interface BatchRow {
  /** Position in the drop, from 1. */
  number: number;
  source: Source;
  status: "waiting" | "running" | "done" | "failed";
  summary?: ClipSummary;
  failure?: Failure;
  /** Hash of the file; absent until it is processed, or if the page was not loaded over https. */
  hash?: string;
  /** True if the user has marked it as checked. */
  isChecked?: boolean;
  /** The letter in all clips of each action of this clip; absent until all clips are processed. */
  actions?: ReadonlyMap<string, string> | undefined;
}

/** The files of the last drop that had several; empty if there was none. */
export const batchRows = signal<readonly BatchRow[]>([]);

/** Number of tables so far. */
export const tableNumber = signal(0);

export const tableVisible = signal(false);

/** Number of the row that has the focus; undefined if none has. */
export const focusedRow = signal<number>();

/** Labels that were dropped on the table and have not been assigned to its clips. */
export const labelsForTable = signal<readonly Source[]>([]);

/** True if a key was pressed that saves the table, which does so. */
export const savesTable = signal(false);

/** Words that the shown rows contain. */
export const tableFilter = signal("");

/** True while clips are processed, also before the first one is shown as running. */
export const isBatchRunning = signal(false);

/** Number of rows that are done or failed. */
export const finishedCount = computed(
  () => batchRows.value.filter(({ status }) => status === "done" || status === "failed").length,
);

/** Options with which the table was computed. */
export const batchRequest = signal<Pick<BatchRequest, "detect" | "segment">>();

/** The row of the open clip, which may have been opened from elsewhere. */
export const openBatchRow = computed(() => {
  const rows = batchRows.value;
  const { source, storageKey } = session.value;
  const isSameFile = ({ hash }: BatchRow) =>
    hash !== undefined && keyOfHash(hash) === storageKey.value;
  return rows.find((row) => row.source === source) ?? rows.find(isSameFile);
});

/** The row of the open clip if its actions are those of the table: of the same options, without overrides. */
const openRowOfTable = computed(() => {
  const { segmentation, overrides } = session.value;
  const options = JSON.stringify(segmentation.value?.options);
  const isSame =
    options === JSON.stringify(batchRequest.value?.segment) &&
    Object.keys(overrides.value).length === 0;
  return isSame ? openBatchRow.value : undefined;
});

/** The first name that the user gave to each action of the table. */
const batchNames = computed(() => {
  const names = new Map<string, string>();
  for (const row of batchRows.value) {
    const { actions, summary } = row;
    if (!actions) continue;
    // The names of the open clip may be newer than its row.
    const { segmentation, segmentNames } = session.value;
    const given =
      row === openRowOfTable.value
        ? namesOfActions(
            segmentation.value?.segments ?? [],
            segmentNames.value,
            segmentation.value?.detected,
          )
        : (summary?.actions?.names ?? []);
    for (const [letter, name] of given) {
      const common = actions.get(letter);
      if (common && !names.has(common)) names.set(common, name);
    }
  }
  return names;
});

/** Returns the letters and names of the actions of a row; undefined until all clips are processed. */
export const vocabularyOf = (row: BatchRow | undefined): Vocabulary | undefined =>
  row?.actions && { actions: row.actions, names: batchNames.value };

/** The letters and names that the open clip shares with the table. */
export const openVocabulary = computed(() => vocabularyOf(openRowOfTable.value));
