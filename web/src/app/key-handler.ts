/** Runs the commands of the page when their keys are pressed. */

import { commandForKey, isEnabled } from "../actions/commands";
import { dialog } from "../store/view";

/** True if the focused control needs the key itself. */
function belongsToControl(event: KeyboardEvent): boolean {
  const target = event.target;
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest("[role=slider]")) return false;
  if (target.matches("input[type=range]")) return /^(Arrow|Home|End|Page)/.test(event.key);
  if (target.closest("input, select, textarea, [role=tablist], [contenteditable]")) return true;
  return /^( |Enter)$/.test(event.key) && target.closest("button, a, summary") !== null;
}

/** True if the key is typed into a text field, which has its own undo. */
function isTyping(event: KeyboardEvent): boolean {
  return event.target instanceof Element && event.target.matches("input[type=text], textarea");
}

export function onKey(event: KeyboardEvent) {
  if (event.defaultPrevented) return;
  const mod = (event.ctrlKey || event.metaKey) && !event.altKey;
  // Many keyboards have brackets on AltGr, and some systems report AltGr as Ctrl and Alt.
  const isBracket = /^[[\]]$/.test(event.key);
  if (!mod && (event.metaKey || ((event.ctrlKey || event.altKey) && !isBracket))) return;
  const command = commandForKey(event, mod);
  if (!command || !isEnabled(command)) return;
  if (!command.isGlobal) {
    if (dialog.value) return;
    if (mod ? isTyping(event) : belongsToControl(event)) return;
  }
  event.preventDefault();
  command.run();
}
