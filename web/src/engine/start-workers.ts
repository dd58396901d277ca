/** Starts the workers, each from a separate file. */

export const startClipWorker = () =>
  new Worker(new URL("../workers/clip.worker.ts", import.meta.url), { type: "module" });

export const startBatchWorker = () =>
  new Worker(new URL("../workers/batch.worker.ts", import.meta.url), { type: "module" });

export const startZipWorker = () =>
  new Worker(new URL("../workers/zip.worker.ts", import.meta.url), { type: "module" });
