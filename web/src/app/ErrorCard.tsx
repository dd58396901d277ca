import { useSignal } from "@preact/signals";
import { excerptWithCaret, failureReport, locationText, toSentence } from "../model/batch/report";
import { type ErrorReport, errorReport } from "../store/errors";
import { opening } from "../store/jobs";
import { clipTitle, openClip } from "../store/session";
import { Icon } from "../ui/icons";

/** The last failure; the previous clip remains open. */
export function ErrorCard() {
  const error = errorReport.value;
  /** The report that was copied last. */
  const copied = useSignal<string | null>(null);
  if (!error) return null;
  const report = failureReport(error.name, error.failure);
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(report);
      copied.value = report;
    } catch {
      copied.value = null;
    }
  };
  return (
    <div class="error-card" role="alert">
      <div class="error-head">
        <h2>
          {error.name} could not be {error.action ?? "opened"}
        </h2>
        <button
          type="button"
          class="button flat icon-only"
          aria-label="Dismiss"
          onClick={() => {
            errorReport.value = null;
          }}
        >
          <Icon name="close" />
        </button>
      </div>
      <Reason report={error} />
      {openClip.value && !opening.value && !error.action && (
        <p class="muted">{clipTitle} is still open.</p>
      )}
      <p class="error-foot">
        {error.retry && (
          <button
            type="button"
            class="button primary"
            onClick={() => {
              errorReport.value = null;
              error.retry?.();
            }}
          >
            Try again
          </button>
        )}
        <button type="button" class="button" onClick={copy}>
          {copied.value === report ? "Copied" : "Copy report"}
        </button>
      </p>
    </div>
  );
}

/** The message of a failure, the line that caused it, and what to do. */
function Reason({ report: { failure, openLeniently } }: { report: ErrorReport }) {
  const location = locationText(failure);
  const excerpt = failure.excerpt ? excerptWithCaret(failure.excerpt, failure.column) : undefined;
  return (
    <>
      <p>{toSentence(failure.message)}</p>
      {location && <p class="muted">At {location}:</p>}
      {excerpt && (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: a scroll container must be focusable by keyboard
        <pre tabIndex={0}>
          {excerpt.line}
          {excerpt.caret && `\n${excerpt.caret}`}
        </pre>
      )}
      {failure.hint && <p>{failure.hint}</p>}
      {openLeniently && (
        <p>
          <button type="button" class="button" onClick={openLeniently}>
            Open leniently
          </button>
        </p>
      )}
    </>
  );
}
