/** The clip that a single-file page contains, or gets from its host. */

import type { AnyEdit } from "../model/segments/cut-edits";
import type { SegmentName } from "../model/segments/segments";
import { blockText, decodeBlock } from "../model/sources/player-html";
import type { Source } from "../model/sources/source";
import { parseChanges } from "../model/stored/stored-changes";

export interface EmbeddedClip {
  version: 1;
  /** Distinguishes several shares of the same clip. */
  id: string;
  name: string;
  /** View state, in the format of links. */
  showing: string;
  edits: readonly AnyEdit[];
  names: readonly SegmentName[];
  /** Address of the app that made the page; absent if that is a local one. */
  home?: string;
}

/** A page in a frame, which gets its clip from the document that contains the frame. */
export interface HostedPage {
  version: 1;
  host: true;
}

/** What this page contains; undefined if it is the app itself. */
export const embedded: EmbeddedClip | HostedPage | undefined =
  JSON.parse(blockText("enclosed") || "null") ?? undefined;

/** True if the page gets its clip from the document that contains its frame. */
export const isHosted = embedded !== undefined && "host" in embedded;

/** True if the page is in a frame, where space is small and other content surrounds it. */
export const isFramed = embedded !== undefined && parent !== window;

/** Decodes the embedded clip, with its edits and names. Throws if the page is damaged. */
export async function embeddedSource({ id, name, ...page }: EmbeddedClip): Promise<Source> {
  const changes = parseChanges(page);
  if (!changes) throw new Error("The edits in this page are damaged.");
  return { name, data: await decodeBlock("clip"), shared: { id, ...changes } };
}
