/** The table of many clips. */

import { computed, signal } from "@preact/signals";
import type { BatchRequest, ClipSummary } from "../model/batch";
import type { Source } from "../model/source";
import type { Failure } from "../model/types";

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
}

/** The files of the last drop that had several; empty if there was none. */
export const batchRows = signal<readonly BatchRow[]>([]);

export const tableVisible = signal(false);

/** Number of rows that are done or failed. */
export const finishedCount = computed(
  () => batchRows.value.filter(({ status }) => status === "done" || status === "failed").length,
);

/** Options with which the table was computed. */
export const batchRequest = signal<Pick<BatchRequest, "detect" | "segment">>();
