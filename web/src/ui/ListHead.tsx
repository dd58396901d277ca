import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import { Icon } from "./icons";

/** Header of a list: its title and count, and a button that expands the export formats. */
export function ListHead({
  title,
  count,
  children,
}: {
  title: string;
  count: number;
  /** Buttons of the export formats. */
  children: ComponentChildren;
}) {
  const isExpanded = useSignal(false);
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
          aria-expanded={isExpanded.value}
          aria-controls={id}
          onClick={() => {
            isExpanded.value = !isExpanded.value;
          }}
        >
          Save
          <Icon name={isExpanded.value ? "collapse" : "expand"} />
        </button>
      </div>
      {isExpanded.value && (
        <div class="save-buttons" id={id}>
          {children}
        </div>
      )}
    </>
  );
}
