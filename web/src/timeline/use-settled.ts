import { type ReadonlySignal, useSignal, useSignalEffect } from "@preact/signals";

/** Milliseconds without a change. */
const wait = 100;

/** A list as it was when it last stopped changing, empty at first: rows that nobody waits for must not hold up a picture. */
export function useSettled<T>(list: ReadonlySignal<readonly T[]>): readonly T[] {
  const settled = useSignal<readonly T[]>([]);
  useSignalEffect(() => {
    const items = list.value;
    const due = setTimeout(() => {
      settled.value = items;
    }, wait);
    return () => clearTimeout(due);
  });
  return settled.value;
}
