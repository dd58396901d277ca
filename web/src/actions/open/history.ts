/** Entries of the browser history for opened clips and the table. */

import type { Source } from "../../model/sources/source";
import { tableNumber, tableVisible } from "../../store/batch";
import { source } from "../../store/session";

/** Clips of the history of this page, by their number in the state of an entry. */
const clips = new Map<number, Source>();

/** The first number. Entries survive a reload, after which the numbers must be other ones. */
const firstNumber = Date.now();

const numberOf = (state: unknown): number | undefined =>
  typeof state === "object" && state !== null && "clip" in state && typeof state.clip === "number"
    ? state.clip
    : undefined;

/** Returns the clip of a history entry, if it was opened since the page was loaded. */
export const clipOfEntry = (state: unknown) => clips.get(numberOf(state) ?? -1);

/** State of the entry of the table. */
interface TableState {
  /** Number of the clip of the previous entry, if it is one. */
  tableAfter: number | undefined;
}

/** True if a history entry is that of the table. */
export const isTableEntry = (state: unknown): state is TableState =>
  typeof state === "object" && state !== null && "tableAfter" in state;

/** Adds an entry for the table to the history, unless it is the current one. */
export function addTableEntry() {
  const { state } = history;
  if (isTableEntry(state)) return;
  const added: TableState = { tableAfter: numberOf(state) };
  history.pushState(added, "", location.pathname + location.search);
}

/** Goes from the entry of the table back to that of the open clip, if this is the previous one. */
export function leaveTableEntry() {
  const { state } = history;
  const opened = source.peek();
  if (opened && isTableEntry(state) && clips.get(state.tableAfter ?? -1) === opened) history.back();
}

/**
 * Adds an entry for the open clip to the history, with the hash that opens it again after a reload; empty
 * if none does.
 */
export function addHistoryEntry(hash: string) {
  const opened = source.peek();
  if (!opened) return;
  const known = [...clips].find(([, other]) => other === opened)?.[0];
  const number = known ?? firstNumber + clips.size;
  clips.set(number, opened);
  const address = hash || location.pathname + location.search;
  const isSameAddress = hash !== "" && location.hash === hash;
  // Opening the same clip again adds nothing.
  if (numberOf(history.state) === number || isSameAddress)
    history.replaceState({ clip: number }, "", address);
  else history.pushState({ clip: number }, "", address);
}

/** Returns a function that shows the opened clip in place of the table, unless there is another table by then. */
export function replaceTable(): () => void {
  const table = tableNumber.peek();
  return () => {
    if (tableNumber.peek() !== table) return;
    tableVisible.value = false;
    addHistoryEntry("");
  };
}
