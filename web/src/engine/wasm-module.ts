/** The wasm modules, each compiled once for all workers of the page. */

import { DownloadError, WorkerError } from "../model/failure";
import firstUrl from "../wasm/plantigrade_bg.wasm?url";
import secondUrl from "../wasm/plantigrade_second.wasm?url";

const bytesOf = (url: string) => fetch(url).then((response) => response.blob());

/** Returns the bytes of the first module and of the second one. */
export async function wasmBytes(): Promise<{ first: Blob; second: Blob }> {
  const [first, second] = await Promise.all([bytesOf(firstUrl), bytesOf(secondUrl)]);
  return { first, second };
}

/** Returns the module with what the first labels require. */
export const wasmModule = compileOnce(
  firstUrl,
  (reason) => new WorkerError(`its module could not be loaded: ${reason}`),
);

/** Returns the module with everything else, which uses the memory of the first one. */
export const secondModule = compileOnce(
  secondUrl,
  (reason) => new DownloadError(`a part of the program could not be loaded: ${reason}`),
);

/** Returns a function that loads a module once; after a failed download, the next call tries again. */
function compileOnce(
  url: string,
  toError: (reason: string) => Error,
): () => Promise<WebAssembly.Module> {
  let compiled: Promise<WebAssembly.Module> | undefined;
  return () => {
    compiled ??= WebAssembly.compileStreaming(fetch(url)).catch((error) => {
      compiled = undefined;
      throw toError(error.message);
    });
    return compiled;
  };
}
