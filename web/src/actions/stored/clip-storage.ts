/**
 * Records and marks of clips in the local storage of the browser, by key. If it is denied, functions of
 * records throw.
 */

import {
  parseRecord,
  type StoredRecord,
  type UnreadableRecord,
} from "../../model/stored/stored-changes";
import { randomId } from "../../util/random-id";

const checkedKeyOfHash = (hash: string) => `plantigrade:checked:${hash}`;

/** Returns the stored mark of a checked file; null if there is none or the storage is denied. */
export function readChecked(hash: string): string | null {
  try {
    return localStorage.getItem(checkedKeyOfHash(hash));
  } catch {
    return null;
  }
}

/** Stores the mark of a checked file, or removes it. If the storage is denied, nothing is stored. */
export function writeChecked(hash: string, text: string | null) {
  try {
    if (text === null) localStorage.removeItem(checkedKeyOfHash(hash));
    else localStorage.setItem(checkedKeyOfHash(hash), text);
  } catch {
    // The mark lasts until the page is closed.
  }
}

/** Prefix of the keys of records that were set aside; a random part and the original key follow. */
const setAsidePrefix = "plantigrade:set-aside:";

/** Records that the browser did not store. They last until the page is closed. */
const unsaved = new Map<string, string>();

/** True if closing the page loses records. */
export const hasUnsaved = () => unsaved.size > 0;

/** Returns the content of a key; null if it has none. */
export const readText = (key: string): string | null => localStorage.getItem(key);

/** Returns the record that could not be stored under a key, if any. */
export const readUnsaved = (key: string): StoredRecord => parseRecord(unsaved.get(key) ?? null);

export function writeText(key: string, text: string) {
  localStorage.setItem(key, text);
  dropUnsaved(key);
}

/** Stores a record in memory that the browser did not store. */
export function keepUnsaved(key: string, text: string) {
  unsaved.set(key, text);
}

/** Forgets a record that could not be stored. */
export function dropUnsaved(key: string) {
  unsaved.delete(key);
}

/** Copies a text to another key, so that its own key can be written. */
export function setAside(key: string, text: string) {
  if (setAsideKeys(key).some((other) => readText(other) === text)) return;
  localStorage.setItem(`${setAsidePrefix}${randomId()}:${key}`, text);
}

const setAsideKeys = (key: string) =>
  Object.keys(localStorage).filter(
    (other) => other.startsWith(setAsidePrefix) && other.endsWith(`:${key}`),
  );

/** Returns the records of a key that cannot be read: those set aside, and the current one. */
export function unreadableRecords(key: string): UnreadableRecord[] {
  const texts = [key, ...setAsideKeys(key)].map(readText);
  return [...new Set(texts)].map(parseRecord).filter((stored) => "text" in stored);
}

/** Deletes the records of a key that cannot be read. */
export function deleteUnreadable(key: string) {
  for (const other of setAsideKeys(key)) localStorage.removeItem(other);
  if ("text" in parseRecord(readText(key))) localStorage.removeItem(key);
}
