/** Where keys go: to the timeline and the view, unless a control is used by keyboard. */

/** Returns the table of clips, or else the playhead, whose keys are those of the page. */
const mainControl = () =>
  document.querySelector<HTMLElement>(".batch") ??
  document.querySelector<HTMLElement>(".playhead-handle");

/** Gives the focus to the playhead, or to the table in front of it. */
export function focusTimeline() {
  const control = mainControl();
  if (control) control.focus({ preventScroll: true });
  else if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
}

/**
 * Gives the focus to the first control near one that had it. The path contains that control and its ancestors. In
 * a panel or a dialog, as well as on a page without timeline, these are the nearest controls; elsewhere, the timeline.
 */
function focusNear(path: readonly Element[]) {
  for (const container of path) {
    if (mainControl() && !container.closest("[role=tabpanel], dialog")) continue;
    if (!container.isConnected) continue;
    for (const control of container.querySelectorAll<HTMLElement>("*")) {
      if (control.tabIndex >= 0) control.focus({ preventScroll: true });
      if (document.activeElement === control) return;
    }
  }
  focusTimeline();
}

/**
 * Returns the focus to the timeline when it or the view is pressed, and after a button or a menu was used
 * with the pointer. A control that received the focus by keyboard retains it; if the control disappears, is hidden or is
 * disabled, the focus goes to one near it.
 */
export function returnFocus(signal: AbortSignal) {
  let usesPointer = false;
  let focusedByPointer: Element | undefined;
  /** The control that has the focus, and its ancestors. */
  let path: Element[] = [];
  const isLost = () => path[0] && (!path[0].isConnected || path[0].matches(":disabled"));
  // Requires the layout.
  const isHidden = () => path[0]?.checkVisibility() === false;
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
      path = [];
      for (let element = target as Element | null; element; element = element.parentElement)
        path.push(element);
    },
    options,
  );
  addEventListener(
    "focusout",
    () =>
      // Elements are still connected while they are removed.
      queueMicrotask(() => {
        if (document.activeElement !== document.body || isLost()) return;
        if (!usesPointer && isHidden() && document.hasFocus()) focusNear(path);
        else path = [];
      }),
    options,
  );
  const observer = new MutationObserver((changes) => {
    const { activeElement, body } = document;
    const hasFocus = activeElement !== body && activeElement !== path[0];
    if (usesPointer || hasFocus || !document.hasFocus()) return;
    // Some browsers leave the focus to a control that is hidden.
    const isPanelToggled = changes.some(({ attributeName }) => attributeName === "data-panel");
    if (isLost() || (isPanelToggled && isHidden())) focusNear(path);
  });
  observer.observe(document.body, {
    attributeFilter: ["disabled", "data-panel"],
    childList: true,
    subtree: true,
  });
  signal.addEventListener("abort", () => observer.disconnect());
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
