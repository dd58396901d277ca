/** What a page in one file holds beside the player. */

import { text, unpacked } from "../lib/blocks";
import type { Named } from "../lib/segments";
import type { Edit } from "../worker/types";
import type { Source } from "./state";

export interface Enclosed {
  version: 1;
  /** Tells it from the same clip shared at another time. */
  id: string;
  name: string;
  /** As in a link. */
  showing: string;
  edits: readonly Edit[];
  names: readonly Named[];
  /** The address of the app it was made with; absent where that is on someone's own computer. */
  home?: string;
}

/** Absent where the page is the app itself. */
export const enclosed: Enclosed | undefined = JSON.parse(text("enclosed") || "null") ?? undefined;

/** The clip in it, with what was changed. */
export async function enclosedSource({ id, name, edits, names }: Enclosed): Promise<Source> {
  return { name, data: await unpacked("clip"), shared: { id, edits, names } };
}
