/** What a person changed, kept in this browser for each file by the hash of its bytes. */

import { effect } from "@preact/signals";
import type { Named } from "../lib/segments";
import type { Edit } from "../worker/types";
import { startEdits } from "./edit";
import { engine } from "./engine";
import { edits, hero, keepFailure, type Source, segmentNames, source } from "./state";

/** What is kept of one clip. */
export interface Kept {
  version: 1;
  /** The file's name, for whoever looks into the browser's storage. */
  name: string;
  edits: readonly Edit[];
  names: readonly Named[];
}

const keyOf = (hash: string) => `plantigrade:clip:${hash}`;

/** Under which key a clip is kept; absent until that is known. */
let known: { key: string; about: Source | null } | undefined;

/** Brings back what was kept of the clip on show. */
export async function recall(): Promise<void> {
  const about = source.value;
  known = undefined;
  keepFailure.value = "";
  const hash = await engine.hash().catch(() => undefined);
  if (source.value !== about || hero.value) return;
  // What was shared is the same on every computer, until it is changed there.
  const key = hash && keyOf(hash) + (about?.shared ? `:${about.shared.id}` : "");
  const kept = (key && read(key)) || about?.shared;
  // Whoever was quick has begun anew meanwhile: then that counts.
  if (kept && !edits.value.length) await startEdits(kept.edits);
  if (kept && !segmentNames.value.length) segmentNames.value = kept.names;
  if (source.value !== about || !key) return;
  known = { key, about };
  keep();
}

/** What was kept of the file with a hash. */
export async function keptOf(hash: string): Promise<Pick<Kept, "edits" | "names">> {
  const { edits, names } = read(keyOf(hash)) ?? { edits: [], names: [] };
  return { edits, names };
}

function read(key: string): Kept | undefined {
  try {
    const kept = JSON.parse(localStorage.getItem(key) ?? "null") as Kept | null;
    return kept?.version === 1 ? kept : undefined;
  } catch {
    return undefined;
  }
}

function keep() {
  // Another clip comes without edits: those of the one before stay kept.
  if (!known || known.about !== source.value) return;
  const kept: Kept = {
    version: 1,
    name: source.value?.name ?? "",
    edits: edits.value,
    names: segmentNames.value,
  };
  try {
    if (kept.edits.length || kept.names.length || known.about?.shared)
      localStorage.setItem(known.key, JSON.stringify(kept));
    else localStorage.removeItem(known.key);
    keepFailure.value = "";
  } catch (error) {
    const isFull = error instanceof DOMException && error.name === "QuotaExceededError";
    keepFailure.value = isFull
      ? "The storage of this browser is full: edits last as long as this page. Save the labels."
      : "This browser keeps nothing for this page: edits last as long as it. Save the labels.";
  }
}

effect(() => {
  void [edits.value, segmentNames.value];
  keep();
});
