import { useSignal } from "@preact/signals";
import { excerptWithCaret, failureReport, place } from "../lib/report";
import { Icon } from "./icons";
import { failure, openClip } from "./state";

/** What went wrong with the last file, over the clip that stays open. */
export function FailureCard() {
  const copied = useSignal(false);
  const held = failure.value;
  if (!held) return null;
  const { name, failure: why } = held;
  const where = place(why);
  const excerpt = why.excerpt ? excerptWithCaret(why.excerpt, why.column) : undefined;
  const close = () => {
    failure.value = null;
    copied.value = false;
  };
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(failureReport(name, why));
      copied.value = true;
    } catch {
      copied.value = false;
    }
  };
  return (
    <div class="failure" role="alert">
      <div class="failure-head">
        <h2>{name} could not be opened</h2>
        <button type="button" class="button plain icon-only" aria-label="Dismiss" onClick={close}>
          <Icon name="close" />
        </button>
      </div>
      <p>{why.message.charAt(0).toUpperCase() + why.message.slice(1)}</p>
      {where && <p class="quiet">At {where}:</p>}
      {excerpt && (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable by keyboard
        <pre tabIndex={0}>
          {excerpt.line}
          {excerpt.caret && `\n${excerpt.caret}`}
        </pre>
      )}
      {why.hint && <p>{why.hint}</p>}
      <p class="failure-foot">
        <button type="button" class="button" onClick={copy}>
          {copied.value ? "Copied" : "Copy report"}
        </button>
        {openClip.value && <span class="quiet">{openClip.value.name} is still open.</span>}
      </p>
    </div>
  );
}
