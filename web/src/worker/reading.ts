/** What all workers do with a file and the module, whatever they read it for. */

import init, { type RawClip, RawReader } from "../wasm/plantigrade";
import { pieces } from "./pieces";
import type { Failure } from "./types";

/** Least time between two reports of progress, in milliseconds. */
const PROGRESS_INTERVAL = 50;

let begin: (module: WebAssembly.Module) => void;

/** Settles when the module runs in this worker: the page compiles it once for all of them. */
export const ready = new Promise<WebAssembly.Module>((resolve) => {
  begin = resolve;
}).then((module) => init({ module_or_path: module }));

export function start(module: WebAssembly.Module) {
  begin(module);
}

/** What the core refuses with a reason comes back as one; anything else is a fault and is thrown. */
export async function refusals<T>(
  work: () => T | Promise<T>,
): Promise<{ ok: true; value: T } | { ok: false; failure: Failure }> {
  try {
    return { ok: true, value: await work() };
  } catch (refusal) {
    if (refusal instanceof Error) throw refusal;
    return { ok: false, failure: refusal as Failure };
  }
}

/** Passes reports on, but not so many that they would take longer than the work. */
export function seldom(onProgress?: (share: number) => void): (share: number) => void {
  let reported = performance.now();
  return (share) => {
    if (!onProgress || performance.now() - reported < PROGRESS_INTERVAL) return;
    reported = performance.now();
    onProgress(share);
  };
}

export async function read(
  file: Blob,
  lenient: boolean,
  report: (share: number) => void,
): Promise<RawClip> {
  const reader = new RawReader(lenient, file.size);
  let done = 0;
  try {
    for await (const piece of pieces(file)) {
      reader.push(piece);
      done += piece.length;
      report(done / file.size);
    }
  } catch (refusal) {
    reader.free();
    throw refusal;
  }
  return reader.finish();
}

/** A file's SHA-256 in hexadecimal; unknown where the browser does not offer it. */
export async function sha256(file: Blob): Promise<string | undefined> {
  if (!globalThis.crypto?.subtle) return undefined;
  const digest = await crypto.subtle.digest("SHA-256", await file.arrayBuffer());
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
