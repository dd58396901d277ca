import { computed, effect, signal } from "@preact/signals";

export type ThemeChoice = "system" | "light" | "dark";

const key = "plantigrade.theme";
const choices: readonly ThemeChoice[] = ["system", "light", "dark"];

function stored(): ThemeChoice {
  try {
    const value = localStorage.getItem(key);
    return choices.find((choice) => choice === value) ?? "system";
  } catch {
    return "system";
  }
}

/** What the person chose. */
export const themeChoice = signal<ThemeChoice>(stored());

const media = matchMedia("(prefers-color-scheme: light)");
const systemLight = signal(media.matches);
media.addEventListener("change", () => {
  systemLight.value = media.matches;
});

/** What the page wears. */
export const theme = computed(() => {
  if (themeChoice.value !== "system") return themeChoice.value;
  return systemLight.value ? "light" : "dark";
});

export function nextTheme() {
  const next = choices[(choices.indexOf(themeChoice.value) + 1) % choices.length] ?? "system";
  themeChoice.value = next;
  try {
    localStorage.setItem(key, next);
  } catch {
    // Private windows may forbid it; the choice then lasts as long as the page.
  }
}

effect(() => {
  document.documentElement.dataset.theme = theme.value;
});
