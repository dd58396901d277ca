/** Where keys go: to the timeline and the view, unless a control is used by keyboard. */

/** Gives the focus to the playhead, whose keys are those of the page. */
export function focusTimeline() {
  const playhead = document.querySelector<HTMLElement>(".playhead-handle");
  if (playhead) playhead.focus({ preventScroll: true });
  else if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
}

/**
 * Returns the focus to the timeline when it or the view is pressed, and after a button or a menu was used
 * with the pointer. A control that received the focus by keyboard retains it.
 */
export function returnFocus(signal: AbortSignal) {
  let usesPointer = false;
  let focusedByPointer: Element | undefined;
  const options = { signal, capture: true };
  addEventListener(
    "pointerdown",
    ({ target }) => {
      usesPointer = true;
      const isSurface =
        target instanceof Element && target.matches(".tracks canvas, .stage canvas");
      if (isSurface) focusTimeline();
    },
    options,
  );
  addEventListener(
    "keydown",
    () => {
      usesPointer = false;
    },
    options,
  );
  addEventListener(
    "focusin",
    ({ target }) => {
      focusedByPointer = usesPointer && target instanceof Element ? target : undefined;
    },
    options,
  );
  const release = (controls: string, { target }: Event) => {
    if (!(target instanceof Element) || target.closest("dialog")) return;
    const control = target.closest<HTMLElement>(controls);
    // An option of a menu that the pointer opened may have been chosen by keyboard.
    if (control && (usesPointer || control === focusedByPointer)) control.blur();
  };
  addEventListener("click", (event) => release("button", event), { signal });
  // A menu is still open when it is clicked.
  addEventListener("change", (event) => release("select, input[type=checkbox]", event), { signal });
}
