import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { dialog } from "../store/view";
import { Icon } from "./icons";
import { Progress } from "./Progress";

/** What lies over the page until it is closed; then the focus is where it was. */
export function Dialog({ title, children }: { title: string; children: ComponentChildren }) {
  const element = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const opener = document.activeElement;
    const held = element.current;
    held?.showModal();
    return () => {
      held?.close();
      if (opener instanceof HTMLElement) opener.focus();
    };
  }, []);
  const close = () => {
    dialog.value = null;
  };
  return (
    <dialog
      ref={element}
      aria-labelledby="dialog-title"
      // By Escape it is closed before it says so: keys must be the page's again at once.
      onCancel={close}
      onClose={close}
      // A press beside the dialog lands on its backdrop, which is the element itself.
      onPointerDown={(event) => event.target === event.currentTarget && close()}
    >
      <div class="dialog-box">
        <div class="dialog-head">
          <h2 id="dialog-title">{title}</h2>
          <button type="button" class="button flat icon-only" aria-label="Close" onClick={close}>
            <Icon name="close" />
          </button>
        </div>
        {children}
      </div>
      <Progress />
    </dialog>
  );
}
