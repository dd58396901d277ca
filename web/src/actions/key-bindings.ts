/** Key bindings: matching key presses, and their display text. */

/** A key as in `KeyboardEvent.key`, lower case, with the modifiers that it requires. */
export interface KeyBinding {
  key: string;
  /** True if Ctrl or ⌘ is required. */
  mod?: boolean;
  shift?: boolean;
}

/** Returns the index of the first list of bindings that contains a key press, or −1. */
export function bindingIndex(
  lists: readonly (readonly KeyBinding[])[],
  event: Pick<KeyboardEvent, "key" | "shiftKey">,
  mod: boolean,
): number {
  const key = event.key.toLowerCase();
  const indexOf = (shift: boolean) =>
    lists.findIndex((bindings) =>
      bindings.some(
        (binding) => binding.key === key && !!binding.mod === mod && !!binding.shift === shift,
      ),
    );
  const exact = indexOf(event.shiftKey);
  // Some characters are typed with Shift, so Shift is compared only if a binding requires it.
  return exact < 0 && !mod ? indexOf(false) : exact;
}

const keyNames: Record<string, string> = {
  " ": "Space",
  arrowleft: "←",
  arrowright: "→",
  escape: "Esc",
  "-": "−",
};

/** Returns the name of the modifier of commands on this computer. */
const modName = () => (/Mac|iP/.test(navigator.platform) ? "⌘" : "Ctrl");

/** Returns the display text of a key: `Ctrl Shift Z`, or `⌘ Shift Z` on a Mac. */
export function keyText({ key, mod, shift }: KeyBinding): string {
  const name = keyNames[key] ?? key.charAt(0).toUpperCase() + key.slice(1);
  return [mod && modName(), shift && "Shift", name].filter(Boolean).join(" ");
}
