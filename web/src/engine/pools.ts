/** The workers that do not hold the open clip. */

import type { BatchApi } from "../workers/batch.worker";
import type { ZipApi } from "../workers/zip.worker";
import { startBatchWorker, startZipWorker } from "./start-workers";
import { wrapWasmWorker, wrapWorker } from "./worker-handle";
import { createPool } from "./worker-pool";

/** Process files of a batch in parallel. */
export const batchWorkers = createPool((onBroken) =>
  wrapWasmWorker<BatchApi>(startBatchWorker(), onBroken),
);

/** Reads and writes archives, one at a time. */
export const zipWorkers = createPool(
  (onBroken) => wrapWorker<ZipApi>(startZipWorker(), onBroken),
  1,
);
