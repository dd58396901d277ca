import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import { Icon } from "./icons";

/** The head of a list: how many there are, and what they are saved as, behind a button. */
export function ListHead({
  title,
  count,
  children,
}: {
  title: string;
  count: number;
  /** The buttons that save. */
  children: ComponentChildren;
}) {
  const isSaving = useSignal(false);
  const id = useId();
  return (
    <>
      <div class="list-head list-head-compact">
        <h2>
          {title} <span class="number">{count}</span>
        </h2>
        <button
          type="button"
          class="button"
          aria-expanded={isSaving.value}
          aria-controls={id}
          onClick={() => {
            isSaving.value = !isSaving.value;
          }}
        >
          Save
          <Icon name={isSaving.value ? "less" : "more"} />
        </button>
      </div>
      {isSaving.value && (
        <div class="save-buttons" id={id}>
          {children}
        </div>
      )}
    </>
  );
}
