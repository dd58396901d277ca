import { computed } from "@preact/signals";
import { errorReport } from "./errors";
import { jobs, opening } from "./jobs";
import { openClip, segmentation } from "./session";

/** The state of the page. */
export const phase = computed(() => {
  if (errorReport.value) return "error";
  if (opening.value) return "loading";
  if (!openClip.value) return "empty";
  return jobs.value.length && !segmentation.value ? "loading" : "ready";
});
