/** The last failure, shown until it is dismissed or another clip is opened. */

import { signal } from "@preact/signals";
import { Cancelled } from "../engine";
import { canReadLeniently } from "../model/batch/report";
import { failureOf } from "../model/failure";
import type { Failure } from "../model/types";

/** A failure and the file or clip that it concerns. */
export interface ErrorReport {
  name: string;
  /** Past participle of what failed, such as "saved". Default: "opened". */
  action?: string;
  failure: Failure;
  /** Opens the file with repairs, if that may help. */
  openLeniently?: () => void;
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
  { openLeniently, retry }: Pick<ErrorReport, "openLeniently" | "retry"> = {},
) {
  errorReport.value = {
    name,
    failure,
    ...(openLeniently && canReadLeniently(failure) && { openLeniently }),
    ...(failure.canRetry && retry && { retry }),
  };
}
