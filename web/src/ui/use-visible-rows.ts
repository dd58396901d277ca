import { useSignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect } from "preact/hooks";

/** The rows of a long list that are in sight, with a few around them: only those need to exist. */
export function useVisibleRows(
  list: RefObject<HTMLElement | null>,
  rowHeight: number,
  rows: number,
): { from: number; to: number } {
  const view = useSignal({ top: 0, height: 600 });
  useEffect(() => {
    const box = list.current;
    const scroller = box?.closest("[data-scrolls]");
    if (!box || !scroller) return;
    const look = () => {
      const top = scroller.getBoundingClientRect().top - box.getBoundingClientRect().top;
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
  }, [view, list]);
  const { top, height } = view.value;
  return {
    from: Math.max(0, Math.floor(top / rowHeight) - 6),
    to: Math.min(rows, Math.ceil((top + height) / rowHeight) + 6),
  };
}
