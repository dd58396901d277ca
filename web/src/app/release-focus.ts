/**
 * A button or menu used with the pointer gives the focus back, so that the next press of
 * Space plays instead of pressing it again. Whoever works by keyboard keeps the focus.
 */
export function releaseFocus(signal: AbortSignal) {
  let byPointer = false;
  const release = (event: Event) => {
    const at = event.target;
    if (!byPointer || !(at instanceof Element) || at.closest("dialog")) return;
    at.closest<HTMLElement>("button, select")?.blur();
  };
  addEventListener(
    "pointerdown",
    () => {
      byPointer = true;
    },
    { signal, capture: true },
  );
  addEventListener(
    "keydown",
    () => {
      byPointer = false;
    },
    { signal, capture: true },
  );
  addEventListener("click", release, { signal });
  addEventListener("change", release, { signal });
}
