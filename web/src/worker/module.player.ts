/** The core that a page in one file holds, compiled once for all its workers. */

import { unpacked } from "../lib/blocks";

export const coreBytes = () => unpacked("core");

let compiled: Promise<WebAssembly.Module> | undefined;

export function coreModule(): Promise<WebAssembly.Module> {
  compiled ??= coreBytes()
    .then((bytes) => bytes.arrayBuffer())
    .then((bytes) => WebAssembly.compile(bytes));
  return compiled;
}
