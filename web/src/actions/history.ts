/** Entries of the browser history for opened clips. */

import type { Source } from "../model/source";
import { source } from "../store/session";

/** Clips of the history of this page, by their number in the state of an entry. */
const clips = new Map<number, Source>();

const numberOf = (state: unknown): number | undefined =>
  typeof state === "object" && state !== null && "clip" in state && typeof state.clip === "number"
    ? state.clip
    : undefined;

/** Returns the clip of a history entry, if it was opened since the page was loaded. */
export const clipOfEntry = (state: unknown) => clips.get(numberOf(state) ?? -1);

/**
 * Adds an entry for the open clip to the history, with the hash that opens it again after a reload; empty
 * if none does.
 */
export function addHistoryEntry(hash: string) {
  const opened = source.peek();
  if (!opened) return;
  const known = [...clips].find(([, other]) => other === opened)?.[0];
  const number = known ?? clips.size + 1;
  clips.set(number, opened);
  const address = hash || location.pathname + location.search;
  const isSameAddress = hash !== "" && location.hash === hash;
  // Opening the same clip again adds nothing.
  if (numberOf(history.state) === number || isSameAddress)
    history.replaceState({ clip: number }, "", address);
  else history.pushState({ clip: number }, "", address);
}
