/** Saving the labels of all clips of the table. */

import * as Comlink from "comlink";
import { batchWorkers, type CallOptions, zipWorkers } from "../../engine";
import type { BatchRequest } from "../../model/batch/batch";
import { tableCsv, titleOf } from "../../model/batch/table";
import type { Vocabulary } from "../../model/segments/segments";
import {
  type BatchRow,
  batchRequest,
  batchRows,
  openBatchRow,
  vocabularyOf,
} from "../../store/batch";
import { runJob } from "../../store/jobs";
import { edits, overrides, segmentNames } from "../../store/session";
import { detectOptions, segmentOptions } from "../../store/settings";
import { showToast } from "../../store/toasts";
import { safeFileName, stemOf, uniqueNames } from "../../util/file-names";
import { flushUpdates, refreshOpenRow } from "../analyse/batch";
import { storedChangesOf } from "../stored/persist";
import { download } from "./download";

/** What an archive contains: the rows of the table, what was requested for them, and the names of their actions. */
interface Snapshot {
  rows: readonly BatchRow[];
  request: Pick<BatchRequest, "detect" | "segment"> | undefined;
  /** By the number of the row. */
  vocabularies: ReadonlyMap<number, Vocabulary | undefined>;
}

const takeSnapshot = (): Snapshot => ({
  rows: batchRows.value,
  request: batchRequest.value,
  vocabularies: new Map(batchRows.value.map((row) => [row.number, vocabularyOf(row)])),
});

/** Returns the table with the newest edits of the open clip, or as it is if another one replaces it meanwhile. */
async function upToDateSnapshot(): Promise<Snapshot> {
  const before = takeSnapshot();
  await refreshOpenRow();
  flushUpdates();
  return batchRequest.value === before.request ? takeSnapshot() : before;
}

/** Reports changes of the open clip that are not saved, because only its own tabs apply them. */
function reportUnsaved(rows: readonly BatchRow[]) {
  const open = openBatchRow.value;
  const row = rows.find(({ number, source }) => number === open?.number && source === open.source);
  if (!row) return;
  const { metresPerUnit, rate, up, roles = {} } = overrides.value;
  const hasOverrides = Boolean(metresPerUnit || rate || up || Object.keys(roles).length);
  // Edits are stored by the hash of the file.
  const hasUnstored = !row.hash && (edits.value.length > 0 || segmentNames.value.length > 0);
  const missing = [
    ...(hasOverrides ? ["the settings of its Clip tab"] : []),
    ...(hasUnstored ? ["your edits, which this browser cannot store"] : []),
  ];
  if (!missing.length) return;
  showToast({
    text: `${titleOf(row)} is saved without ${missing.join(" and ")}. Save it with them in its Labels and Segment tabs.`,
  });
}

/** Downloads labels and segments of all clips, and the table, in one archive. */
export async function exportAll(): Promise<void> {
  const { rows, request: options, vocabularies } = await upToDateSnapshot();
  const done = rows.filter(({ status }) => status === "done");
  reportUnsaved(done);
  const request: BatchRequest = {
    save: true,
    ...(options ?? { detect: detectOptions.value, segment: segmentOptions.value }),
  };
  const names = uniqueNames(done.map(({ source }) => safeFileName(stemOf(source.name))));
  const writeArchive = ({ signal, onProgress }: CallOptions) =>
    zipWorkers.run(async (zip) => {
      let count = 0;
      const addFiles = async (
        { number, source: { name, data, lenient = false } }: BatchRow,
        i: number,
      ) => {
        const vocabulary = vocabularies.get(number);
        const rowRequest = { ...request, lenient, ...(vocabulary && { vocabulary }) };
        const result = await batchWorkers.run(
          (calls) => calls.summarize(data, name, rowRequest, [], Comlink.proxy(storedChangesOf)),
          signal,
        );
        if (!result.ok) throw new Error(`${name}: ${result.failure.message}`);
        for (const { extension, data } of result.files)
          await zip.add(`${names[i]}.${extension}`, data);
        onProgress?.(++count / done.length);
      };
      await Promise.all(done.map(addFiles));
      const savedAs = new Map(done.map((row, i) => [row, names[i] ?? ""]));
      await zip.add("table.csv", tableCsv(rows, savedAs));
      return zip.finish();
    }, signal);
  await download("labels.zip", () =>
    runJob({ title: "Saving", name: "labels.zip" }, new AbortController(), writeArchive),
  );
}
