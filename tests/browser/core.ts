/** Lists of the core, with which those of the app are compared. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { initSync, methods, segmentMethods } from "../../web/src/wasm/plantigrade";
import { root } from "./clips";

/** Returns the names of all detection and segmentation methods, the default first. */
export function methodNames(): { detect: string[]; segment: string[] } {
  initSync({ module: readFileSync(join(root, "web/src/wasm/plantigrade_bg.wasm")) });
  const names = (list: readonly { name: string }[]) => list.map(({ name }) => name);
  return { detect: names(methods()), segment: names(segmentMethods()) };
}
