/** Starts the workers: each is a file beside the page. */

export const startClipWorker = () =>
  new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });

export const startSurveyor = () =>
  new Worker(new URL("./surveyor.ts", import.meta.url), { type: "module" });

export const startArchivist = () =>
  new Worker(new URL("./archivist.ts", import.meta.url), { type: "module" });
