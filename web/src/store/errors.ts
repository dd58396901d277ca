/** The last failure, shown until it is dismissed or another clip is opened. */

import { signal } from "@preact/signals";
import { Cancelled } from "../engine";
import { failureOf } from "../model/failure";
import type { Source } from "../model/sources/source";
import type { Failure } from "../model/types";

/** A failure and the file or clip that it concerns. */
export interface ErrorReport {
  name: string;
  /** Past participle of what failed, such as "saved". Default: "opened". */
  action?: string;
  failure: Failure;
  /** The file, if it can be opened again in another way. */
  source?: Source;
  /** Repeats what failed, if that may help. */
  retry?: () => void;
}

export const errorReport = signal<ErrorReport | null>(null);

/** Reports that something could not be done with the open clip or one of its files, unless it was cancelled. */
export function reportFailure(action: string, name: string, error: unknown, retry?: () => void) {
  if (error instanceof Cancelled) return;
  const failure = failureOf(error);
  errorReport.value = {
    name,
    action,
    failure,
    ...(failure.canRetry && retry && { retry }),
  };
}

/** Reports that a file could not be opened. */
export function reportOpenFailure(
  name: string,
  failure: Failure,
  { source, retry }: Pick<ErrorReport, "source" | "retry"> = {},
) {
  errorReport.value = {
    name,
    failure,
    ...(source && { source }),
    ...(failure.canRetry && retry && { retry }),
  };
}
