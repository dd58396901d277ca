/** Runs the commands of the page when their keys are pressed. */

import { commandForKey, isEnabled } from "../actions/commands";
import { tableVisible } from "../store/batch";
import { dialog } from "../store/view";
import { focusTimeline } from "./focus";

const isArrow = (key: string) => /^(Arrow|Home|End|Page)/.test(key);

/** True if the focused control needs the key itself; single letters never belong to menus. */
function belongsToControl({ target, key }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest("[role=slider]")) return false;
  if (target.closest("[role=separator], [role=tablist]"))
    return isArrow(key) || isPress(target, key);
  if (target.matches("input[type=range]")) return isArrow(key);
  if (target.matches("input[type=number]")) return isArrow(key) || /^([-+.,\de]|.{2,})$/i.test(key);
  if (target.matches("input[type=checkbox]")) return key === " ";
  if (target.matches("select")) return isArrow(key) || /^( |Enter|Escape)$/.test(key);
  if (target.closest("input, textarea, [contenteditable]")) return true;
  return isPress(target, key);
}

/** True if the key presses a button or follows a link. */
const isPress = (target: HTMLElement, key: string) =>
  /^( |Enter)$/.test(key) && target.closest("button, a, summary") !== null;

/** True if the key is typed into a text field, which has its own undo. */
function isTyping(event: KeyboardEvent): boolean {
  return (
    event.target instanceof Element &&
    event.target.matches("input[type=text], input[type=search], textarea")
  );
}

export function onKey(event: KeyboardEvent) {
  if (event.defaultPrevented) return;
  const { target } = event;
  if (event.key === "Enter" && target instanceof Element && target.matches("input[type=number]")) {
    // Enter completes the number, and the keys belong to the timeline again.
    focusTimeline();
    return;
  }
  const mod = (event.ctrlKey || event.metaKey) && !event.altKey;
  // Many keyboards have brackets on AltGr, and some systems report AltGr as Ctrl and Alt.
  const isBracket = /^[[\]]$/.test(event.key);
  if (!mod && (event.metaKey || ((event.ctrlKey || event.altKey) && !isBracket))) return;
  const command = commandForKey(event, mod);
  if (!command || (mod && !isEnabled(command))) return;
  if (!command.isGlobal) {
    if (dialog.value) return;
    if (mod ? isTyping(event) : belongsToControl(event)) return;
  }
  // A key whose command is not possible now must not reach a menu either, but it may scroll the table.
  if (isEnabled(command) || !tableVisible.value) event.preventDefault();
  if (isEnabled(command)) command.run();
}
