/** The colour theme: the choice of the user, or that of the system. */

import { computed, effect, signal } from "@preact/signals";
import type { ThemeChoice } from "../model/types";

const storageKey = "plantigrade.theme";
const choices: readonly ThemeChoice[] = ["system", "light", "dark"];

export const themeChoice = signal<ThemeChoice>("system");

const systemIsLight = signal(false);

/** The theme in use. */
export const theme = computed(() => {
  if (themeChoice.value !== "system") return themeChoice.value;
  return systemIsLight.value ? "light" : "dark";
});

/** Restores the choice, follows the system, and applies the theme to the document. */
export function startTheme() {
  themeChoice.value = storedChoice();
  const media = matchMedia("(prefers-color-scheme: light)");
  systemIsLight.value = media.matches;
  media.addEventListener("change", () => {
    systemIsLight.value = media.matches;
  });
  effect(() => {
    document.documentElement.dataset.theme = theme.value;
  });
}

/** Chooses the next theme: system, light, dark, system. */
export function nextTheme() {
  const next = choices[(choices.indexOf(themeChoice.value) + 1) % choices.length] ?? "system";
  themeChoice.value = next;
  try {
    localStorage.setItem(storageKey, next);
  } catch {
    // Private windows may forbid storage; the choice then lasts until the page is closed.
  }
}

function storedChoice(): ThemeChoice {
  try {
    const value = localStorage.getItem(storageKey);
    return choices.find((choice) => choice === value) ?? "system";
  } catch {
    return "system";
  }
}
