import { useSignal } from "@preact/signals";
import { openSource } from "../actions/open";
import {
  canReadLeniently,
  excerptWithCaret,
  failureReport,
  locationText,
  toSentence,
} from "../model/report";
import { type ErrorReport, errorReport } from "../store/errors";
import { openClip } from "../store/session";
import { Icon } from "../ui/icons";

/** What went wrong with the last file, over the clip that stays open. */
export function ErrorCard() {
  const held = errorReport.value;
  /** What was copied: another failure can be copied anew. */
  const copied = useSignal<string | null>(null);
  if (!held) return null;
  const report = failureReport(held.name, held.failure);
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(report);
      copied.value = report;
    } catch {
      copied.value = null;
    }
  };
  return (
    <div class="failure" role="alert">
      <div class="failure-head">
        <h2>
          {held.name} could not be {held.action ?? "opened"}
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
      <Reason of={held} />
      {openClip.value && !held.action && <p class="muted">{openClip.value.name} is still open.</p>}
      <p class="failure-foot">
        <button type="button" class="button" onClick={copy}>
          {copied.value === report ? "Copied" : "Copy report"}
        </button>
      </p>
    </div>
  );
}

/** Why one file was refused, the line it is about, and the way out. */
function Reason({ of: { failure: why, source } }: { of: ErrorReport }) {
  const where = locationText(why);
  const excerpt = why.excerpt ? excerptWithCaret(why.excerpt, why.column) : undefined;
  return (
    <>
      <p>{toSentence(why.message)}</p>
      {where && <p class="muted">At {where}:</p>}
      {excerpt && (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable by keyboard
        <pre tabIndex={0}>
          {excerpt.line}
          {excerpt.caret && `\n${excerpt.caret}`}
        </pre>
      )}
      {why.hint && <p>{why.hint}</p>}
      {source && canReadLeniently(why) && (
        <p>
          <button
            type="button"
            class="button"
            onClick={() => openSource(source, { lenient: true })}
          >
            Open leniently
          </button>
        </p>
      )}
    </>
  );
}
