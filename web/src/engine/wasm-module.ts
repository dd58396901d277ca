/** The wasm module, compiled once for all workers of the page. */

import { WorkerError } from "../model/failure";
import url from "../wasm/plantigrade_bg.wasm?url";

export const wasmBytes = () => fetch(url).then((response) => response.blob());

let compiled: Promise<WebAssembly.Module> | undefined;

/** Returns the compiled module; a failed download is tried again by the next call. */
export function wasmModule(): Promise<WebAssembly.Module> {
  compiled ??= WebAssembly.compileStreaming(fetch(url)).catch((error) => {
    compiled = undefined;
    throw new WorkerError(`its module could not be loaded: ${error.message}`);
  });
  return compiled;
}
