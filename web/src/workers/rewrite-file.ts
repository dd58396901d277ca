/** Writes a changed clip from its file. */

import type { WasmRewriter } from "../wasm/plantigrade";
import { readChunks } from "./read-blob";

/** Returns the bytes of a file with the numbers that the writer replaces. */
export async function rewriteFile(file: Blob, rewriter: WasmRewriter): Promise<Blob> {
  const written: Uint8Array<ArrayBuffer>[] = [];
  try {
    for await (const chunk of readChunks(file)) {
      written.push(rewriter.push(chunk) as Uint8Array<ArrayBuffer>);
    }
  } catch (error) {
    rewriter.free();
    throw error;
  }
  written.push(rewriter.finish() as Uint8Array<ArrayBuffer>);
  return new Blob(written, { type: "text/plain" });
}
