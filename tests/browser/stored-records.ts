/** Records of edits in the storage of the browser. */

import { createHash } from "node:crypto";
import type { App } from "./app";
import type { Payload } from "./clips";

/** Returns the storage key of a clip. */
export const keyOf = ({ buffer }: Payload) =>
  `plantigrade:clip:${createHash("sha256").update(buffer).digest("hex")}`;

/** Stores a text as the record of a clip. */
export const storeRecord = (app: App, clip: Payload, text: string) =>
  app.page.evaluate(([key, text]) => localStorage.setItem(key, text), [keyOf(clip), text] as const);
