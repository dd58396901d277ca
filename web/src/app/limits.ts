import { bytes } from "../lib/time";
import type { Failure } from "../worker/types";

/** Larger files are refused before a byte is read: a worker's memory ends at a few times that. */
export const sizeLimit = 2 ** 30;

/** Why a file of so many bytes is not opened. */
export const tooLarge = (size: number): Failure => ({
  message: `The file has ${bytes(size)}; the limit is ${bytes(sizeLimit)}.`,
  hint: "Split the clip, or leave out joints nobody needs, and export it again.",
});
