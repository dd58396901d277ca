/** The wasm modules that a single-file page contains, each compiled once for all workers. */

import { type BlockId, decodeBlock } from "../model/sources/player-html";

export async function wasmBytes(): Promise<{ first: Blob; second: Blob }> {
  return { first: await decodeBlock("core"), second: await decodeBlock("second") };
}

export const wasmModule = compileOnce("core");

export const secondModule = compileOnce("second");

function compileOnce(block: BlockId): () => Promise<WebAssembly.Module> {
  let compiled: Promise<WebAssembly.Module> | undefined;
  return () => {
    compiled ??= decodeBlock(block)
      .then((bytes) => bytes.arrayBuffer())
      .then((bytes) => WebAssembly.compile(bytes));
    return compiled;
  };
}
