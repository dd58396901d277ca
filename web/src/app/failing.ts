import { batch } from "@preact/signals";
import type { Failure } from "../worker/types";
import type { Refusal, Source } from "./state";
import { failure, refused, refusedShown, task } from "./state";

export const messageOf = (error: unknown) =>
  error instanceof Error ? error.message : String(error);

/** Tells that something could not be opened; nothing is being opened any more. */
export function fail(name: string, why: Failure, source?: Source) {
  batch(() => {
    task.value = null;
    failure.value = source ? { name, failure: why, source } : { name, failure: why };
  });
}

/** Tells of all refused files of one drop at once. */
export function refuse(refusals: readonly Refusal[]) {
  batch(() => {
    failure.value = null;
    refused.value = refusals;
    refusedShown.value = refusals.length > 0;
  });
}
