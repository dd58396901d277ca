import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { place } from "../lib/report";
import { Icon } from "./icons";
import { keyTable } from "./keys";
import { clip, dialog, notices } from "./state";
import { startTour } from "./Tour";

export function Dialogs() {
  if (dialog.value === "keys") return <KeysDialog />;
  if (dialog.value === "notices") return <NoticesDialog />;
  return null;
}

function Dialog({ title, children }: { title: string; children: ComponentChildren }) {
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
          <button type="button" class="button plain icon-only" aria-label="Close" onClick={close}>
            <Icon name="close" />
          </button>
        </div>
        {children}
      </div>
    </dialog>
  );
}

function KeysDialog() {
  return (
    <Dialog title="Keys">
      <div class="key-groups">
        {keyTable.map(([group, rows]) => (
          <section key={group}>
            <h3>{group}</h3>
            <dl>
              {rows.map(([keys, what]) => (
                <div key={keys}>
                  <dt>
                    {keys.split(" ").map((key) => (
                      <kbd key={key}>{key}</kbd>
                    ))}
                  </dt>
                  <dd>{what}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
      <p class="note">
        On the timeline: wheel zooms, Shift and wheel or a middle drag pans, a click on a bar goes
        to its start, a drag of its end moves it, a double click on a segment names it.
      </p>
      <button
        type="button"
        class="button"
        onClick={() => {
          dialog.value = null;
          startTour();
        }}
      >
        Show the tour
      </button>
    </Dialog>
  );
}

function NoticesDialog() {
  return (
    <Dialog title={`Notices on ${clip.value?.name ?? ""}`}>
      <ul class="notices">
        {notices.value.map((notice, i) => (
          <li key={i}>
            <p>{notice.text}</p>
            <p class="quiet">
              <code>{notice.code}</code>
              {place(notice) && ` ${place(notice)}`}
            </p>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
