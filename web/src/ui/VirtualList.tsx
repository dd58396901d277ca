import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { isTouch } from "./touch";
import { useVisibleRows } from "./use-visible-rows";

const rowHeight = isTouch() ? 44 : 36;

/** A list that renders only the visible rows, for thousands of items. */
export function VirtualList<T>({
  items,
  renderRow,
  visibleIndex,
  scrollsAtFirst = false,
}: {
  items: readonly T[];
  renderRow: (item: T) => ComponentChildren;
  /** Index of an item to scroll to. */
  visibleIndex?: number | undefined;
  /** True if the list scrolls to that item when it appears, too. Default false. */
  scrollsAtFirst?: boolean;
}) {
  const container = useRef<HTMLDivElement>(null);
  const { from, to } = useVisibleRows(container, rowHeight, items.length);
  const isMounted = useRef(false);
  useEffect(() => {
    // The panel opens at its top.
    const isFirst = !isMounted.current;
    isMounted.current = true;
    if (isFirst && !scrollsAtFirst) return;
    const scroller = container.current?.closest("[data-scrolls]");
    if (visibleIndex === undefined || !scroller || !container.current) return;
    const listTop =
      container.current.getBoundingClientRect().top - scroller.getBoundingClientRect().top;
    const top = listTop + visibleIndex * rowHeight;
    if (top < 0 || top + rowHeight > scroller.clientHeight) {
      scroller.scrollTop += top - (scroller.clientHeight - rowHeight) / 2;
    }
  }, [visibleIndex]);
  return (
    <div ref={container}>
      <ol
        class="virtual-list"
        ref={(element) => element?.style.setProperty("height", `${items.length * rowHeight}px`)}
      >
        {items.slice(from, to).map((item, i) => (
          <li
            key={from + i}
            aria-posinset={from + i + 1}
            aria-setsize={items.length}
            ref={(element) => element?.style.setProperty("top", `${(from + i) * rowHeight}px`)}
          >
            {renderRow(item)}
          </li>
        ))}
      </ol>
    </div>
  );
}
