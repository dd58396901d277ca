/** Functions shared by the workers: starting the wasm module, reading a clip, reporting failures. */

import { failureOf, WorkerError } from "../model/failure";
import type { Failure, OnProgress } from "../model/types";
import init, { type WasmClip, WasmReader } from "../wasm/plantigrade";
import { readChunks } from "./read-blob";

const PROGRESS_INTERVAL_MS = 50;

let resolveModule: (module: WebAssembly.Module) => void;

/** Resolves when the module, which the page compiles once for all workers, runs in this one. */
export const wasmReady = new Promise<WebAssembly.Module>((resolve) => {
  resolveModule = resolve;
})
  .then((module) => init({ module_or_path: module }))
  .catch((error: Error) => {
    throw new WorkerError(`its module could not be started: ${error.message}`);
  });

// Each call reports the failure; a worker without a call does not.
wasmReady.catch(() => {});

export function startWasm(module: WebAssembly.Module) {
  resolveModule(module);
}

/** Returns a failure of the core as a value; throws any other error. */
export async function toResult<T>(
  call: () => T | Promise<T>,
): Promise<{ ok: true; value: T } | { ok: false; failure: Failure }> {
  try {
    return { ok: true, value: await call() };
  } catch (error) {
    if (error instanceof Error) throw error;
    return { ok: false, failure: failureOf(error) };
  }
}

/** Limits how often progress is reported. */
export function throttle(onProgress?: OnProgress): OnProgress {
  let reported = performance.now();
  return (fraction) => {
    if (!onProgress || performance.now() - reported < PROGRESS_INTERVAL_MS) return;
    reported = performance.now();
    onProgress(fraction);
  };
}

export async function readClip(
  file: Blob,
  lenient: boolean,
  onProgress: OnProgress,
): Promise<WasmClip> {
  const reader = new WasmReader(lenient, file.size);
  let done = 0;
  try {
    for await (const chunk of readChunks(file)) {
      reader.push(chunk);
      done += chunk.length;
      onProgress(done / file.size);
    }
  } catch (error) {
    reader.free();
    throw error;
  }
  return reader.finish();
}

/** Returns the SHA-256 of a file in hexadecimal; undefined if the browser does not offer it. */
export async function sha256(file: Blob): Promise<string | undefined> {
  if (!globalThis.crypto?.subtle) return undefined;
  const digest = await crypto.subtle.digest("SHA-256", await file.arrayBuffer());
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
