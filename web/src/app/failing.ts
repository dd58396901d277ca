import { batch } from "@preact/signals";
import type { Failure } from "../worker/types";
import { failure, type Source, task } from "./state";

export const messageOf = (error: unknown) =>
  error instanceof Error ? error.message : String(error);

/** Tells that something could not be opened; nothing is being opened any more. */
export function fail(name: string, why: Failure, source?: Source) {
  batch(() => {
    task.value = null;
    failure.value = source ? { name, failure: why, source } : { name, failure: why };
  });
}
