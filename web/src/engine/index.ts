/** The workers of the page. */

import { createEngine } from "./clip-engine";

export {
  type CallOptions,
  Cancelled,
  type ClipEngine,
  type OpenOptions,
  Superseded,
} from "./clip-engine";
export { batchWorkers, zipWorkers } from "./pools";
export { wasmModule } from "./wasm-module";

/** The worker that holds the open clip. */
export const engine = createEngine();
