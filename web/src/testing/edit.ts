import type { Edit } from "../model/types";

/** Returns an edit of ten frames in which the left foot is planted, for tests. */
export const edit = (start: number): Edit => ({
  side: "left",
  part: "contact",
  start,
  end: start + 10,
  planted: true,
});
