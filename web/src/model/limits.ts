import { formatBytes } from "../util/format";
import type { Failure } from "./types";

/** Maximum file size, checked before reading; a worker needs a few times as much memory. */
export const maxFileBytes = 2 ** 30;

/** Maximum number of files of one drop. */
export const maxFiles = 5000;

/** Returns the failure of opening a file above the limit. */
export const fileTooLarge = (size: number): Failure => ({
  message: `The file has ${formatBytes(size)}; the limit is ${formatBytes(maxFileBytes)}.`,
  hint: "Split the clip or remove unneeded joints, and export it again.",
});
