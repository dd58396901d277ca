import { useSignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect } from "preact/hooks";

/**
 * Returns the range of visible rows of a long list in its scroll container (`data-scrolls`), with a
 * few rows more at both ends.
 */
export function useVisibleRows(
  list: RefObject<HTMLElement | null>,
  rowHeight: number,
  rowCount: number,
): { from: number; to: number } {
  const view = useSignal({ top: 0, height: 600 });
  useEffect(() => {
    const element = list.current;
    const scroller = element?.closest("[data-scrolls]");
    if (!element || !scroller) return;
    const measure = () => {
      const top = scroller.getBoundingClientRect().top - element.getBoundingClientRect().top;
      view.value = { top, height: scroller.clientHeight };
    };
    measure();
    scroller.addEventListener("scroll", measure, { passive: true });
    const observer = new ResizeObserver(measure);
    observer.observe(scroller);
    return () => {
      scroller.removeEventListener("scroll", measure);
      observer.disconnect();
    };
  }, [view, list]);
  const { top, height } = view.value;
  return {
    from: Math.max(0, Math.floor(top / rowHeight) - 6),
    to: Math.min(rowCount, Math.ceil((top + height) / rowHeight) + 6),
  };
}
