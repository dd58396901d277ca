/** The core, compiled once for all workers of the page. */

import address from "../wasm/plantigrade_bg.wasm?url";

/** The bytes of it. */
export const coreBytes = () => fetch(address).then((response) => response.blob());

let compiled: Promise<WebAssembly.Module> | undefined;

/** The compiled module; one that could not be had is asked for again the next time. */
export function coreModule(): Promise<WebAssembly.Module> {
  compiled ??= WebAssembly.compileStreaming(fetch(address)).catch((error) => {
    compiled = undefined;
    throw new Error(`the program could not be loaded (${error.message}): reload the page`);
  });
  return compiled;
}
