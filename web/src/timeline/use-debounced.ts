import { type ReadonlySignal, useSignal, useSignalEffect } from "@preact/signals";

/** Time without a change before the list is updated, in milliseconds. */
const delay = 100;

/** Returns a list as it was when it last stopped changing; empty at first. */
export function useDebounced<T>(list: ReadonlySignal<readonly T[]>): readonly T[] {
  const debounced = useSignal<readonly T[]>([]);
  useSignalEffect(() => {
    const items = list.value;
    const timer = setTimeout(() => {
      debounced.value = items;
    }, delay);
    return () => clearTimeout(timer);
  });
  return debounced.value;
}
