import { signal } from "@preact/signals";
import type { Companion } from "../model/source";

/** Clips shown side by side with the open one, in the order in which they were added. */
export const companions = signal<readonly Companion[]>([]);

/** Maximum number of companions. */
export const maxCompanions = 5;
