import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useId, useRef } from "preact/hooks";

/** A button that opens a small panel, which closes on Escape and when something else is pressed or gets the focus. */
export function Menu({
  label,
  title,
  children,
}: {
  label: ComponentChildren;
  title: string;
  children: ComponentChildren;
}) {
  const isOpen = useSignal(false);
  const id = useId();
  const menu = useRef<HTMLDivElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (!isOpen.value) return;
    const controller = new AbortController();
    const options = { signal: controller.signal };
    for (const type of ["pointerdown", "focusin"]) {
      addEventListener(
        type,
        ({ target }) => {
          if (target instanceof Node && !menu.current?.contains(target)) isOpen.value = false;
        },
        options,
      );
    }
    addEventListener(
      "keydown",
      (event) => {
        if (event.key !== "Escape") return;
        event.preventDefault();
        isOpen.value = false;
        button.current?.focus();
      },
      { ...options, capture: true },
    );
    return () => controller.abort();
  }, [isOpen.value]);
  return (
    <div class="menu" ref={menu}>
      <button
        type="button"
        class="button flat"
        ref={button}
        title={title}
        aria-expanded={isOpen.value}
        aria-controls={id}
        onClick={() => {
          isOpen.value = !isOpen.value;
        }}
      >
        {label}
      </button>
      {isOpen.value && (
        <div
          class="menu-panel"
          id={id}
          ref={(element) => {
            const top = button.current?.getBoundingClientRect().top ?? 0;
            element?.style.setProperty("--space-above", `${top}px`);
          }}
        >
          {children}
        </div>
      )}
    </div>
  );
}
