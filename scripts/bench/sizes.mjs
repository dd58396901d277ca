/** Rows on download sizes. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";
import { root } from "../run.mjs";
import { timeRow } from "./pairs.mjs";

/** Returns rows on the compressed sizes of the site, in kilobytes. */
export function sizeRows() {
  const assets = join(root, "web/dist/assets");
  const total = (ending, start = "") =>
    readdirSync(assets)
      .filter((name) => name.endsWith(ending) && name.startsWith(start))
      .reduce((sum, name) => sum + compressedSize(join(assets, name)), 0);
  const row = (work, bytes, limit) => ({
    ...timeRow(work, "limit", [{ ours: bytes, reference: limit }], 1),
    text: (value) => `${(value / 1000).toFixed(0)} KB`,
  });
  return [
    row("WebAssembly for the first labels, with Brotli", total(".wasm", "plantigrade_bg"), 160_000),
    row("all WebAssembly, with Brotli", total(".wasm"), 360_000),
    row("all scripts, with Brotli", total(".js"), 300_000),
  ];
}

/** Returns the size of a file compressed with Brotli at the highest quality, in bytes. */
function compressedSize(path) {
  const params = { [constants.BROTLI_PARAM_QUALITY]: 11 };
  return brotliCompressSync(readFileSync(path), { params }).length;
}
