/** Starts the workers of a single-file page, which contains them as text. */

import BatchWorker from "../workers/batch.worker?worker&inline";
import ClipWorker from "../workers/clip.worker?worker&inline";
import ZipWorker from "../workers/zip.worker?worker&inline";

export const startClipWorker = () => new ClipWorker();
export const startBatchWorker = () => new BatchWorker();
export const startZipWorker = () => new ZipWorker();
