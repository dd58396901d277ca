/** A single-file page has no samples. */

import type { Sample } from "./samples";

export const samples: readonly Sample[] = [];
export const previewSample = samples[0];
