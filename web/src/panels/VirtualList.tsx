import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

const rowHeight = 36;

/** A list of which only the rows in sight exist: an hour of walking has thousands. */
export function VirtualList<T>({
  items,
  row,
  shown,
}: {
  items: readonly T[];
  row: (item: T) => ComponentChildren;
  /** Place of an item to bring into sight. */
  shown?: number | undefined;
}) {
  const box = useRef<HTMLDivElement>(null);
  const view = useSignal({ top: 0, height: 600 });
  useEffect(() => {
    const scroller = box.current?.closest(".panel-body");
    if (!scroller || !box.current) return;
    const list = box.current;
    const look = () => {
      const top = scroller.getBoundingClientRect().top - list.getBoundingClientRect().top;
      view.value = { top, height: scroller.clientHeight };
    };
    look();
    scroller.addEventListener("scroll", look, { passive: true });
    const observer = new ResizeObserver(look);
    observer.observe(scroller);
    return () => {
      scroller.removeEventListener("scroll", look);
      observer.disconnect();
    };
  }, [view]);
  useEffect(() => {
    const scroller = box.current?.closest(".panel-body");
    if (shown === undefined || !scroller || !box.current) return;
    const list = box.current.getBoundingClientRect().top - scroller.getBoundingClientRect().top;
    const at = list + shown * rowHeight;
    if (at < 0 || at + rowHeight > scroller.clientHeight) {
      scroller.scrollTop += at - (scroller.clientHeight - rowHeight) / 2;
    }
  }, [shown]);
  const { top, height } = view.value;
  const from = Math.max(0, Math.floor(top / rowHeight) - 6);
  const to = Math.min(items.length, Math.ceil((top + height) / rowHeight) + 6);
  return (
    <div ref={box}>
      <ol
        class="plants"
        ref={(el) => el?.style.setProperty("height", `${items.length * rowHeight}px`)}
      >
        {items.slice(from, to).map((item, i) => (
          <li
            key={from + i}
            aria-posinset={from + i + 1}
            aria-setsize={items.length}
            ref={(el) => el?.style.setProperty("top", `${(from + i) * rowHeight}px`)}
          >
            {row(item)}
          </li>
        ))}
      </ol>
    </div>
  );
}
