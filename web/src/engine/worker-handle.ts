/** Workers as the page calls them. */

import * as Comlink from "comlink";
import { wasmModule } from "./wasm-module";

/** The methods of a worker API, with the signatures that they have in the worker. */
export type CallsOf<Api> = {
  [Name in keyof Api]: Api[Name] extends (...args: infer Args) => infer Answer
    ? (...args: Args) => Answer
    : never;
};

/** A running worker. */
export interface WorkerHandle<Api> {
  calls: CallsOf<Api>;
  stop: () => void;
}

/** Wraps a worker; `onBroken` is called if it fails outside of a call. */
export function wrapWorker<Api>(
  worker: Worker,
  onBroken: (reason: Error) => void,
): WorkerHandle<Api> {
  worker.addEventListener("error", (event) =>
    onBroken(new Error(event.message || "The worker failed.")),
  );
  // Comlink's types distribute promises over unions; the answers have the types of the worker.
  const calls = Comlink.wrap<Api>(worker) as unknown as CallsOf<Api>;
  return { calls, stop: () => worker.terminate() };
}

/** Wraps a worker that waits for the wasm module, and sends it. */
export function wrapWasmWorker<Api extends { startWasm(module: WebAssembly.Module): void }>(
  worker: Worker,
  onBroken: (reason: Error) => void,
): WorkerHandle<Api> {
  const handle = wrapWorker<Api>(worker, onBroken);
  wasmModule().then((module) => handle.calls.startWasm(module), onBroken);
  return handle;
}

/** True if the wasm module trapped. Errors lose their class, but not their name, in transit. */
export function isTrap(error: unknown): boolean {
  return error instanceof Error && error.name === "RuntimeError";
}
