/** Messages that do not interrupt the user. */

import { signal } from "@preact/signals";

export interface Toast {
  text: string;
  /** Optional button. */
  action?: { name: string; run: () => void };
}

export const toasts = signal<readonly Toast[]>([]);

export function showToast(toast: Toast) {
  toasts.value = [...toasts.value, toast];
}

export function dismissToast(toast: Toast) {
  toasts.value = toasts.peek().filter((other) => other !== toast);
}
