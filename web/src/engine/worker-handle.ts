/** Workers as the page calls them. */

import * as Comlink from "comlink";
import { WorkerError } from "../model/failure";
import { randomId } from "../util/random-id";
import { secondModule, wasmModule } from "./wasm-module";

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

/** What every worker offers. */
interface WatchedApi {
  holdLock(name: string): Promise<boolean>;
}

/** Time after which a worker that has not answered is replaced. */
const startTimeoutMs = 20_000;

/** Wraps a worker; `onBroken` is called if it fails outside of a call, ends or does not start. */
export function wrapWorker<Api extends WatchedApi>(
  worker: Worker,
  onBroken: (reason: Error) => void,
): WorkerHandle<Api> {
  worker.addEventListener("error", (event) =>
    onBroken(new WorkerError(event.message || "the worker could not be loaded")),
  );
  // Comlink's types distribute promises over unions; the answers have the types of the worker.
  const calls = Comlink.wrap<Api>(worker) as unknown as CallsOf<Api>;
  const controller = new AbortController();
  void watch(calls as unknown as CallsOf<WatchedApi>, onBroken, controller.signal);
  const stop = () => {
    controller.abort();
    worker.terminate();
  };
  return { calls, stop };
}

/** Reports a worker that ends or does not start, for which browsers have no event. */
async function watch(
  calls: CallsOf<WatchedApi>,
  onBroken: (reason: Error) => void,
  signal: AbortSignal,
) {
  const lock = `plantigrade:worker:${randomId()}`;
  const timeout = setTimeout(
    () => onBroken(new WorkerError("the worker did not start")),
    startTimeoutMs,
  );
  signal.addEventListener("abort", () => clearTimeout(timeout));
  const isHeld = await calls.holdLock(lock);
  clearTimeout(timeout);
  if (!isHeld || signal.aborted) return;
  try {
    // Granted when the worker no longer exists.
    await navigator.locks.request(lock, { signal }, () => {});
  } catch {
    return;
  }
  onBroken(new WorkerError("the worker was ended, perhaps for lack of memory"));
}

/** What every worker offers that waits for the wasm module. */
interface WasmApi extends WatchedApi {
  startWasm(module: WebAssembly.Module, requestSecondModule: () => Promise<void>): void;
  startSecondModule(module: WebAssembly.Module): Promise<void>;
}

/** Wraps a worker that waits for the wasm module, and sends it; the worker requests the second one. */
export function wrapWasmWorker<Api extends WasmApi>(
  worker: Worker,
  onBroken: (reason: Error) => void,
): WorkerHandle<Api> {
  const handle = wrapWorker<Api>(worker, onBroken);
  const request = Comlink.proxy(async () => handle.calls.startSecondModule(await secondModule()));
  wasmModule().then((module) => handle.calls.startWasm(module, request), onBroken);
  return handle;
}
