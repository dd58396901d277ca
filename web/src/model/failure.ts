/** Failures as they are shown to the user. */

import type { Failure } from "./types";

/** The error of a worker that ended or did not start. */
export class WorkerError extends Error {
  override readonly name = "WorkerError";
}

/** A part of the program could not be downloaded; the next call tries again. */
export class DownloadError extends Error {
  override readonly name = "DownloadError";
}

/** Names of errors after which a worker is replaced: traps, and lack of memory or stack. */
const fatalNames = ["WorkerError", "RuntimeError", "RangeError"];

/** True if a worker has to be replaced. Errors lose their class, but not their name, in transit. */
export const isFatal = (error: unknown): error is Error =>
  error instanceof Error && fatalNames.includes(error.name);

/** Returns the failure for any thrown value; those of the core are objects, but not errors. */
export function failureOf(error: unknown): Failure {
  const { message, name } = (error ?? {}) as Partial<Error>;
  if (isFatal(error)) {
    return {
      message: `the program failed (${message || name})`,
      hint: "The worker was restarted; your edits were not lost. Try again. If that fails too, please report the problem, with the file if possible.",
      canRetry: true,
    };
  }
  if (error instanceof Error && name === "DownloadError") {
    const hint = "Check the connection to the network, then try again. Nothing was lost.";
    return { message: message ?? "", hint, canRetry: true };
  }
  if (error instanceof Error) return { message: message || name || "unknown error" };
  if (typeof message === "string" && message) return error as Failure;
  return { message: typeof error === "string" && error ? error : "unknown error" };
}

/** Returns the message of any thrown value. */
export const messageOf = (error: unknown) => failureOf(error).message;
