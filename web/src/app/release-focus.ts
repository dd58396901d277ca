/**
 * Removes the focus from buttons and menus after they are used with the pointer, so that Space plays
 * instead of pressing them again. After use by keyboard the focus stays.
 */
export function releaseFocus(signal: AbortSignal) {
  let usesPointer = false;
  const release = (event: Event) => {
    const { target } = event;
    if (!usesPointer || !(target instanceof Element) || target.closest("dialog")) return;
    target.closest<HTMLElement>("button, select")?.blur();
  };
  addEventListener(
    "pointerdown",
    () => {
      usesPointer = true;
    },
    { signal, capture: true },
  );
  addEventListener(
    "keydown",
    () => {
      usesPointer = false;
    },
    { signal, capture: true },
  );
  addEventListener("click", release, { signal });
  addEventListener("change", release, { signal });
}
