import { batch } from "@preact/signals";
import type { Failure } from "../worker/types";
import { failure, type Source, task } from "./state";

export const messageOf = (error: unknown) =>
  error instanceof Error ? error.message : String(error);

/** Tells that something could not be done with the clip on show, or a file of it. */
export function failTo(what: string, name: string, error: unknown) {
  failure.value = {
    name,
    what,
    failure: { message: messageOf(error), ...(isFault(error) && faultHint) },
  };
}

/** A fault of the program itself, for which the worker was replaced. */
const isFault = (error: unknown) => error instanceof Error && error.name === "RuntimeError";

const faultHint = {
  hint: "This part of the program has been started anew; your edits are kept. Please report it, with the file if you may share it.",
};

/** Tells that something could not be opened; nothing is being opened any more. */
export function fail(name: string, why: Failure, source?: Source) {
  batch(() => {
    task.value = null;
    failure.value = source ? { name, failure: why, source } : { name, failure: why };
  });
}
