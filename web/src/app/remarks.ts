/** What the page has to say that stops nobody. */

import { signal } from "@preact/signals";

export interface Remark {
  text: string;
  /** What a person may do about it. */
  action?: { name: string; act: () => void };
}

export const remarks = signal<readonly Remark[]>([]);

export function remark(made: Remark) {
  remarks.value = [...remarks.value, made];
}

export function dismiss(remark: Remark) {
  remarks.value = remarks.value.filter((other) => other !== remark);
}
