import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { useVisibleRows } from "./use-visible-rows";

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
  const { from, to } = useVisibleRows(box, rowHeight, items.length);
  useEffect(() => {
    const scroller = box.current?.closest("[data-scrolls]");
    if (shown === undefined || !scroller || !box.current) return;
    const list = box.current.getBoundingClientRect().top - scroller.getBoundingClientRect().top;
    const at = list + shown * rowHeight;
    if (at < 0 || at + rowHeight > scroller.clientHeight) {
      scroller.scrollTop += at - (scroller.clientHeight - rowHeight) / 2;
    }
  }, [shown]);
  return (
    <div ref={box}>
      <ol
        class="virtual-list"
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
