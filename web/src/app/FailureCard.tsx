import { useSignal } from "@preact/signals";
import { excerptWithCaret, failureReport, mendable, place, sentence } from "../lib/report";
import { Icon } from "./icons";
import { openSource } from "./open";
import { failure, openClip, type Refusal } from "./state";

/** What went wrong with the last file, over the clip that stays open. */
export function FailureCard() {
  const held = failure.value;
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
          {held.name} could not be {held.what ?? "opened"}
        </h2>
        <button
          type="button"
          class="button plain icon-only"
          aria-label="Dismiss"
          onClick={() => {
            failure.value = null;
          }}
        >
          <Icon name="close" />
        </button>
      </div>
      <Reason of={held} />
      {openClip.value && !held.what && <p class="quiet">{openClip.value.name} is still open.</p>}
      <p class="failure-foot">
        <button type="button" class="button" onClick={copy}>
          {copied.value === report ? "Copied" : "Copy report"}
        </button>
      </p>
    </div>
  );
}

/** Why one file was refused, the line it is about, and the way out. */
function Reason({ of: { failure: why, source } }: { of: Refusal }) {
  const where = place(why);
  const excerpt = why.excerpt ? excerptWithCaret(why.excerpt, why.column) : undefined;
  return (
    <>
      <p>{sentence(why.message)}</p>
      {where && <p class="quiet">At {where}:</p>}
      {excerpt && (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable by keyboard
        <pre tabIndex={0}>
          {excerpt.line}
          {excerpt.caret && `\n${excerpt.caret}`}
        </pre>
      )}
      {why.hint && <p>{why.hint}</p>}
      {source && mendable(why) && (
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
