/** Saving the labels of all clips of the table. */

import * as Comlink from "comlink";
import { batchWorkers, type CallOptions, zipWorkers } from "../../engine";
import type { BatchRequest } from "../../model/batch/batch";
import { tableCsv } from "../../model/batch/table";
import { type BatchRow, batchRequest, batchRows, vocabularyOf } from "../../store/batch";
import { runJob } from "../../store/jobs";
import { detectOptions, segmentOptions } from "../../store/settings";
import { safeFileName, stemOf, uniqueNames } from "../../util/file-names";
import { flushUpdates, refreshOpenRow } from "../analyse/batch";
import { storedChangesOf } from "../stored/persist";
import { download } from "./download";

/** Downloads labels and segments of all clips, and the table, in one archive. */
export async function exportAll(): Promise<void> {
  await refreshOpenRow();
  flushUpdates();
  const done = batchRows.value.filter(({ status }) => status === "done");
  const request: BatchRequest = {
    save: true,
    ...(batchRequest.peek() ?? { detect: detectOptions.value, segment: segmentOptions.value }),
  };
  const names = uniqueNames(done.map(({ source }) => safeFileName(stemOf(source.name))));
  const writeArchive = ({ signal, onProgress }: CallOptions) =>
    zipWorkers.run(async (zip) => {
      let count = 0;
      const addFiles = async (row: BatchRow, i: number) => {
        const { name, data } = row.source;
        const vocabulary = vocabularyOf(row);
        const rowRequest = vocabulary ? { ...request, vocabulary } : request;
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
      await zip.add("table.csv", tableCsv(batchRows.value));
      return zip.finish();
    }, signal);
  await download("labels.zip", () =>
    runJob({ title: "Saving", name: "labels.zip" }, new AbortController(), writeArchive),
  );
}
