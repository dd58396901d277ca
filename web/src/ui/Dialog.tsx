import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { dialog } from "../store/view";
import { Icon } from "./icons";
import { Progress } from "./Progress";

/** A modal dialog. Closing it returns the focus to the element that had it before. */
export function Dialog({ title, children }: { title: string; children: ComponentChildren }) {
  const element = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const opener = document.activeElement;
    const modal = element.current;
    modal?.showModal();
    return () => {
      modal?.close();
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
      // Escape fires cancel before close: shortcuts of the page must work again immediately.
      onCancel={close}
      // Another dialog may have replaced this one by then.
      onClose={(event) => event.currentTarget.isConnected && close()}
      // A press on the backdrop targets the dialog element itself.
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
      <div class="status-cards">
        <Progress />
      </div>
    </dialog>
  );
}
