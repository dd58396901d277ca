/** A worker as the page calls it. */

import * as Comlink from "comlink";
import { coreModule } from "./module";

/** The calls of a worker, as it has them. */
export type CallsOf<Api> = {
  [Call in keyof Api]: Api[Call] extends (...args: infer Given) => infer Got
    ? (...args: Given) => Got
    : never;
};

/** A worker that runs. */
export interface Thread<Api> {
  calls: CallsOf<Api>;
  stop: () => void;
}

/** The calls of a worker; `onBroken` is told when it fails by itself. */
export function thread<Api>(worker: Worker, onBroken: (reason: Error) => void): Thread<Api> {
  worker.addEventListener("error", (event) =>
    onBroken(new Error(event.message || "The worker failed.")),
  );
  // Comlink splits unions over promises; the calls are as the worker has them.
  const calls = Comlink.wrap<Api>(worker) as unknown as CallsOf<Api>;
  return { calls, stop: () => worker.terminate() };
}

/** The same of a worker that waits for the core, which is sent to it. */
export function coreThread<Api extends { start(module: WebAssembly.Module): void }>(
  worker: Worker,
  onBroken: (reason: Error) => void,
): Thread<Api> {
  const made = thread<Api>(worker, onBroken);
  coreModule().then((module) => made.calls.start(module), onBroken);
  return made;
}

/** Errors lose their class on the way from the worker, but not their name. */
export function isTrap(error: unknown): boolean {
  return error instanceof Error && error.name === "RuntimeError";
}
