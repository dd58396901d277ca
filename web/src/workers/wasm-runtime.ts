/** Functions shared by the workers: starting the wasm module, reading a clip, reporting failures. */

import { failureOf, WorkerError } from "../model/failure";
import type { DetectOptions, Failure, OnProgress } from "../model/types";
import init, { methods, type WasmClip, WasmReader } from "../wasm/plantigrade";
import { type FileData, readChunks, sizeOf } from "./read-blob";

const PROGRESS_INTERVAL_MS = 50;

/** Has the page, which compiles the second module once for all workers, call `startSecondModule`. */
type RequestModule = () => Promise<void>;

let resolveModule: (module: WebAssembly.Module) => void;
let requestSecondModule: RequestModule;

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

export function startWasm(module: WebAssembly.Module, requestSecond: RequestModule) {
  requestSecondModule = requestSecond;
  resolveModule(module);
}

let second: Promise<unknown> | undefined;

/**
 * Resolves when the second module runs, which contains all functions that the first labels do not require.
 * Without it, a call of such a function traps. If it cannot be loaded, the next call tries again.
 */
export function secondReady(): Promise<unknown> {
  second ??= loadSecond().catch((error) => {
    second = undefined;
    throw error;
  });
  return second;
}

async function loadSecond() {
  await wasmReady;
  await requestSecondModule();
}

/**
 * Starts the second module. The page sends it by this call: in a page from disk, an answer to a request, which
 * takes another channel, cannot contain a module.
 */
export async function startSecondModule(module: WebAssembly.Module): Promise<void> {
  const first = await wasmReady;
  // It puts its functions and data into the table and the memory of the first module.
  await WebAssembly.instantiate(module, { __wasm_split: { ...first } });
}

/**
 * Returns an API whose calls wait for the second module, except for those that are named. They fail if the
 * state has been replaced meanwhile, so that they do not apply to another clip.
 */
export function withSecondModule<Api extends object>(
  api: Api,
  firstCalls: readonly (keyof Api)[],
  state: () => unknown,
): Api {
  const waiting = (call: (...args: unknown[]) => unknown) => {
    return async (...args: unknown[]) => {
      const before = state();
      await secondReady();
      if (state() !== before) throw new Error("Another clip was opened.");
      return call(...args);
    };
  };
  const entries = Object.entries(api).map(([name, call]) => [
    name,
    firstCalls.includes(name as keyof Api) ? call : waiting(call),
  ]);
  return Object.fromEntries(entries);
}

/** Waits for the second module if a detection requires it: all methods but the default one. */
export async function methodReady({ method }: DetectOptions): Promise<void> {
  defaultMethod ??= methods()[0]?.name;
  if (method !== defaultMethod) await secondReady();
}

let defaultMethod: string | undefined;

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
  file: FileData,
  lenient: boolean,
  onProgress: OnProgress,
): Promise<WasmClip> {
  const size = sizeOf(file);
  const reader = new WasmReader(lenient, size);
  let done = 0;
  try {
    for await (const chunk of readChunks(file)) {
      reader.push(chunk);
      done += chunk.length;
      onProgress(done / size);
    }
  } catch (error) {
    reader.free();
    throw error;
  }
  return reader.finish();
}

/** Returns the SHA-256 of a file in hexadecimal; undefined if the browser does not offer it. */
export async function sha256(file: FileData): Promise<string | undefined> {
  if (!globalThis.crypto?.subtle) return undefined;
  const bytes = file instanceof Blob ? await file.arrayBuffer() : file;
  const digest = await crypto.subtle.digest("SHA-256", bytes);
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
