/** Stores edits and names in this browser, for each file by the hash of its bytes. */

import { effect } from "@preact/signals";
import { engine } from "../engine";
import type { StoredChanges } from "../model/batch";
import type { SegmentName } from "../model/segments";
import type { Edit } from "../model/types";
import { type ClipSession, session } from "../store/clip-session";
import { initEdits } from "./edit";

interface StoredClip {
  version: 1;
  /** Name of the file, for people who inspect the storage. */
  name: string;
  edits: readonly Edit[];
  names: readonly SegmentName[];
}

const keyOf = (hash: string) => `plantigrade:clip:${hash}`;

/** Restores the stored edits and names of the open clip. */
export async function restorePersisted(): Promise<void> {
  const clipSession = session.value;
  const hash = await clipSession.run("hash", () => engine.hash().catch(() => undefined));
  if (clipSession.signal.aborted || clipSession.isPreview) return;
  const shared = clipSession.source?.shared;
  // Each share of a clip is stored separately.
  const key = hash && keyOf(hash) + (shared ? `:${shared.id}` : "");
  const stored = (key && read(key)) || shared;
  // Changes made before the hash was known take precedence.
  if (stored && !clipSession.edits.value.length) await initEdits(clipSession, stored.edits);
  if (stored && !clipSession.segmentNames.value.length)
    clipSession.segmentNames.value = stored.names;
  if (key) clipSession.storageKey.value = key;
}

/** Returns the stored edits and names of the file with a hash. */
export async function storedChangesOf(hash: string): Promise<StoredChanges> {
  const { edits, names } = read(keyOf(hash)) ?? { edits: [], names: [] };
  return { edits, names };
}

function read(key: string): StoredClip | undefined {
  try {
    const stored = JSON.parse(localStorage.getItem(key) ?? "null") as StoredClip | null;
    return stored?.version === 1 ? stored : undefined;
  } catch {
    return undefined;
  }
}

/** Stores the edits and names of the open clip whenever they change. */
export function startPersisting() {
  effect(() => persist(session.value));
}

function persist(clipSession: ClipSession) {
  const key = clipSession.storageKey.value;
  const [edits, names] = [clipSession.edits.value, clipSession.segmentNames.value];
  if (!key) return;
  const stored: StoredClip = { version: 1, name: clipSession.source?.name ?? "", edits, names };
  try {
    if (edits.length || names.length || clipSession.source?.shared)
      localStorage.setItem(key, JSON.stringify(stored));
    else localStorage.removeItem(key);
    clipSession.persistError.value = "";
  } catch (error) {
    const isFull = error instanceof DOMException && error.name === "QuotaExceededError";
    clipSession.persistError.value = isFull
      ? "The storage of this browser is full: edits last until the page is closed. Save the labels."
      : "This browser does not store data for this page: edits last until it is closed. Save the labels.";
  }
}
