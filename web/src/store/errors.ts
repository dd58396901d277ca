/** The last failure, shown until it is dismissed or another clip is opened. */

import { batch, signal } from "@preact/signals";
import type { Source } from "../model/source";
import type { Failure } from "../model/types";
import { opening } from "./jobs";

/** A failure and the file or clip that it concerns. */
export interface ErrorReport {
  name: string;
  /** Past participle of what failed, such as "saved". Default: "opened". */
  action?: string;
  failure: Failure;
  /** The file, if it can be opened again in another way. */
  source?: Source;
}

export const errorReport = signal<ErrorReport | null>(null);

/** Returns the message of an error or of any other thrown value. */
export const messageOf = (error: unknown) =>
  error instanceof Error ? error.message : String(error);

/** Reports that something could not be done with the open clip or one of its files. */
export function reportFailure(action: string, name: string, error: unknown) {
  errorReport.value = {
    name,
    action,
    failure: { message: messageOf(error), ...(isTrap(error) && trapHint) },
  };
}

/** True if the wasm module trapped, in which case its worker is replaced. */
const isTrap = (error: unknown) => error instanceof Error && error.name === "RuntimeError";

const trapHint = {
  hint: "The worker was restarted; your edits were not lost. Please report the problem, with the file if possible.",
};

/** Reports that a file could not be opened, and ends the opening. */
export function reportOpenFailure(name: string, failure: Failure, source?: Source) {
  batch(() => {
    opening.value = null;
    errorReport.value = source ? { name, failure, source } : { name, failure };
  });
}
