/** A page in one file holds its clip and no others. */

import type { Sample } from "./samples";

export const samples: readonly Sample[] = [];
export const heroSample = samples[0];
