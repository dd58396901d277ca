/** The wasm module that a single-file page contains, compiled once for all workers. */

import { decodeBlock } from "../model/player-html";

export const wasmBytes = () => decodeBlock("core");

let compiled: Promise<WebAssembly.Module> | undefined;

export function wasmModule(): Promise<WebAssembly.Module> {
  compiled ??= wasmBytes()
    .then((bytes) => bytes.arrayBuffer())
    .then((bytes) => WebAssembly.compile(bytes));
  return compiled;
}
