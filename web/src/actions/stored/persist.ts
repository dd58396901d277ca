/**
 * Stores edits and names in this browser, for each file by the hash of its bytes. Pages that have
 * the same clip open merge their changes.
 *
 * A lock around reading and writing would not suffice, because a browser may give each page a
 * cached copy of the storage. Instead, a record lists the revisions from which it was made: a page
 * that knows a later one merges its changes into the record.
 */

import { batch, effect } from "@preact/signals";
import { engine } from "../../engine";
import type { StoredChanges } from "../../model/batch/batch";
import { messageOf } from "../../model/failure";
import {
  isConflict,
  keyOfHash,
  mergeChanges,
  nextRecord,
  noChanges,
  parseRecord,
  type StoredClip,
  sameChanges,
} from "../../model/stored/stored-changes";
import { type ClipSession, session } from "../../store/clip-session";
import { isHosted } from "../../store/embedded";
import { dismissToast, showToast, type Toast } from "../../store/toasts";
import { announce, showTab } from "../../store/view";
import { stemOf } from "../../util/file-names";
import { commitEdits, replaceEdits } from "../edit/edit";
import { shareWithHost } from "../host";
import { download } from "../save/download";
import {
  deleteUnreadable,
  dropUnsaved,
  hasUnsaved,
  keepUnsaved,
  readText,
  readUnsaved,
  setAside,
  unreadableRecords,
  writeText,
} from "./clip-storage";

/**
 * Restores the stored edits and names of the open clip, and stores them when they change. A page in a frame
 * leaves both to its host.
 */
export async function restorePersisted(): Promise<void> {
  const clipSession = session.value;
  if (clipSession.isPreview) return;
  if (isHosted) return shareWithHost(clipSession);
  const hash = await clipSession.run("hash", hashOfClip);
  if (!hash) return;
  if ("failure" in hash) {
    const stop = effect(() => reportUnidentified(clipSession, hash.failure));
    clipSession.signal.addEventListener("abort", stop);
    return;
  }
  const shared = clipSession.source?.shared;
  // Each share of a clip is stored separately.
  const key = keyOfHash(hash.value) + (shared ? `:${shared.id}` : "");
  clipSession.storageKey.value = key;
  await new StoredSession(clipSession, key).start(shared ?? noChanges);
}

/** Returns the hash of the open clip, or why it is unknown. */
async function hashOfClip(): Promise<{ value: string } | { failure: string }> {
  for (let attempt = 1; ; attempt++) {
    try {
      const value = await engine.hash();
      return value ? { value } : { failure: "this page was not loaded over https" };
    } catch (error) {
      // The worker may have been stopped because of another call.
      if (attempt === 3) return { failure: messageOf(error) };
    }
  }
}

function reportUnidentified(clipSession: ClipSession, reason: string) {
  clipSession.persistError.value = sameChanges(changesOf(clipSession), noChanges)
    ? ""
    : `Edits of this clip cannot be stored (${reason}). Save the labels before you open another clip.`;
}

const changesOf = (clipSession: ClipSession): StoredChanges => ({
  edits: clipSession.edits.value,
  names: clipSession.segmentNames.value,
});

type Revision = StoredChanges & Pick<StoredClip, "revision" | "ancestors" | "similarSettled">;

/** Synchronizes the changes of a clip and their record as long as the clip is open. */
class StoredSession {
  /** The content of the storage when it was last read or written, if it was valid. */
  private lastText: string | null = null;
  private last: Revision = {
    ...noChanges,
    revision: "",
    ancestors: [],
    similarSettled: false,
  };
  /** Changes by revision, for the revisions that this page has read or written. */
  private readonly known = new Map<string, StoredChanges>();

  constructor(
    private readonly clipSession: ClipSession,
    private readonly key: string,
  ) {}

  /** Restores the record, or else the given changes. */
  async start(initial: StoredChanges): Promise<void> {
    const { clipSession, key } = this;
    this.last = { ...this.last, ...initial };
    this.known.set("", initial);
    const { signal } = clipSession;
    const onStorage = (event: StorageEvent) => {
      if (event.key === key) void this.receive(event.newValue, { notify: true });
    };
    addEventListener("storage", onStorage, { signal });
    await this.take(initial, noChanges);
    try {
      clipSession.unreadable.value = unreadableRecords(key);
      await this.receive(readText(key), { notify: false });
    } catch {
      // Storage is denied, which is reported when something has to be stored.
    }
    this.reportRestored(initial);
    const unsaved = readUnsaved(key);
    if (unsaved.kind === "valid")
      await this.takeRecord(unsaved.record, this.baseOf(unsaved.record));
    if (!signal.aborted)
      signal.addEventListener(
        "abort",
        effect(() => this.save()),
      );
  }

  /** Reports that edits of an earlier visit were applied. */
  private reportRestored(initial: StoredChanges) {
    const { clipSession } = this;
    const changes = changesOf(clipSession);
    if (clipSession.signal.aborted || sameChanges(changes, initial)) return;
    const toast: Toast = {
      text: "Your stored edits of this clip were applied.",
      action: {
        name: "Show",
        run: () => {
          dismissToast(toast);
          showTab(changes.edits.length ? "labels" : "segment");
        },
      },
    };
    showToast(toast);
    // It is out of date once the user works on the labels.
    const stop = effect(() => {
      if (clipSession.selected.value || clipSession.undoStack.value.length) dismissToast(toast);
    });
    clipSession.signal.addEventListener("abort", () => {
      stop();
      dismissToast(toast);
    });
  }

  /** Returns the newest changes that a record and this page have in common. */
  private baseOf({ revision, ancestors }: Revision): StoredChanges {
    const common = [revision, ...ancestors, ""].find((id) => this.known.has(id));
    return this.known.get(common ?? "") ?? noChanges;
  }

  /** Merges changes into those of the session. */
  private take(remote: StoredChanges, base: StoredChanges): Promise<void> {
    const { clipSession } = this;
    const { names } = changesOf(clipSession);
    const merge = (edits: StoredChanges["edits"]) => mergeChanges(base, { edits, names }, remote);
    clipSession.segmentNames.value = merge([]).names;
    return replaceEdits(clipSession, (edits) => merge(edits).edits);
  }

  /** Merges a record into the session. Whether similar plants are settled applies to exactly its edits. */
  private takeRecord(record: StoredClip, base: StoredChanges): Promise<void> {
    const { clipSession } = this;
    return batch(() => {
      const taken = this.take(record, base);
      const { edits, similarSettledFor } = clipSession;
      if (record.similarSettled && edits.value === record.edits)
        similarSettledFor.value = edits.value;
      return taken;
    });
  }

  /** Reads the content of the storage, which another page may have changed. */
  private async receive(text: string | null, { notify }: { notify: boolean }): Promise<void> {
    const { clipSession } = this;
    const stored = parseRecord(text);
    if (stored.kind === "none" || text === this.lastText) return;
    if (stored.kind !== "valid") {
      clipSession.unreadable.value = unreadableRecords(this.key);
      return;
    }
    const { record } = stored;
    const base = this.baseOf(record);
    const local = changesOf(clipSession);
    await batch(() => {
      this.remember(text, record);
      if (notify && !sameChanges(local, record)) {
        clipSession.changedElsewhere.value = isConflict(base, local, record)
          ? { remote: record }
          : {};
        announce("Edits of this clip were changed in another tab");
      }
      return this.takeRecord(record, base);
    });
  }

  private remember(text: string | null, revision: Revision) {
    this.lastText = text;
    this.last = revision;
    this.known.set(revision.revision, revision);
  }

  private nextRecord(): StoredClip {
    const { clipSession, last } = this;
    const content = { ...changesOf(clipSession), similarSettled: clipSession.isSimilarSettled };
    return nextRecord(last, clipSession.source?.name ?? "", content);
  }

  /** Stores the changes of the session if they differ from the record. */
  private save() {
    const { clipSession, key, last } = this;
    const isSame = clipSession.isSimilarSettled === last.similarSettled;
    if (sameChanges(changesOf(clipSession), last) && isSame) {
      dropUnsaved(key);
      clipSession.persistError.value = "";
      return;
    }
    try {
      const text = readText(key);
      // The event of another page may be late.
      void this.receive(text, { notify: true });
      if (text !== null && text !== this.lastText) setAside(key, text);
      const record = this.nextRecord();
      const next = JSON.stringify(record);
      writeText(key, next);
      this.remember(next, record);
      clipSession.persistError.value = "";
    } catch (error) {
      keepUnsaved(key, JSON.stringify(this.nextRecord()));
      const isFull = error instanceof DOMException && error.name === "QuotaExceededError";
      clipSession.persistError.value = isFull
        ? "The storage of this browser is full: edits last until the page is closed. Save the labels."
        : "This browser does not store data for this page: edits last until it is closed. Save the labels.";
    }
  }
}

/** Returns the stored edits and names of the file with a hash. */
export async function storedChangesOf(hash: string): Promise<StoredChanges> {
  try {
    const key = keyOfHash(hash);
    const unsaved = readUnsaved(key);
    const stored = unsaved.kind === "valid" ? unsaved : parseRecord(readText(key));
    if (stored.kind === "valid") return stored.record;
    return { ...noChanges, isUnreadable: stored.kind !== "none" };
  } catch {
    // The storage is denied.
    return noChanges;
  }
}

/** Replaces the changes that conflict with those of another page; this can be undone. */
export function useChangesElsewhere() {
  const clipSession = session.value;
  const { remote } = clipSession.changedElsewhere.value ?? {};
  if (!remote) return;
  dismissChangesElsewhere();
  clipSession.segmentNames.value = remote.names;
  void commitEdits(remote.edits, "Edits replaced by those of the other tab");
}

export function dismissChangesElsewhere() {
  session.value.changedElsewhere.value = null;
}

/** Downloads the stored records of the open clip that cannot be read. */
export function saveUnreadable(): Promise<void> {
  const { source, unreadable } = session.value;
  const texts = unreadable.value.map(({ text }) => text);
  const name = `${stemOf(source?.name ?? "clip")}.stored-edits.txt`;
  return download(name, async () => new Blob([texts.join("\n\n")], { type: "text/plain" }));
}

/** Deletes the stored records of the open clip that cannot be read. */
export function discardUnreadable() {
  const { storageKey, unreadable } = session.value;
  if (storageKey.value) deleteUnreadable(storageKey.value);
  unreadable.value = [];
  announce("Unreadable edits deleted");
}

/** Asks before the page is closed if that loses edits. */
export function warnBeforeLoss() {
  addEventListener("beforeunload", (event) => {
    const { pendingEdits, persistError } = session.value;
    if (hasUnsaved() || persistError.value || pendingEdits > 0) event.preventDefault();
  });
}
