import { formatBytes } from "../util/format";
import type { Failure } from "./types";

/** Larger files are refused before a byte is read: a worker's memory ends at a few times that. */
export const maxFileBytes = 2 ** 30;

/** Why a file of so many bytes is not opened. */
export const fileTooLarge = (size: number): Failure => ({
  message: `The file has ${formatBytes(size)}; the limit is ${formatBytes(maxFileBytes)}.`,
  hint: "Split the clip, or leave out joints nobody needs, and export it again.",
});
