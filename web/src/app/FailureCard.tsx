import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { excerptWithCaret, failureReport, mendable, place, sentence } from "../lib/report";
import { Icon } from "./icons";
import { openSource } from "./open";
import { failure, openClip, type Refusal, refused, refusedShown } from "./state";

/** What went wrong with the last file or files, over the clip that stays open. */
export function FailureCard() {
  if (failure.value) {
    const held = failure.value;
    const dismiss = () => {
      failure.value = null;
    };
    return (
      <Card title={titleOf(held)} about={[held]} dismiss={dismiss}>
        <Reason of={held} />
        {openClip.value && <p class="quiet">{openClip.value.name} is still open.</p>}
      </Card>
    );
  }
  const several = refused.value;
  const [first] = several;
  if (!first || !refusedShown.value) return null;
  const dismiss = () => {
    refusedShown.value = false;
  };
  if (several.length === 1) {
    return (
      <Card title={titleOf(first)} about={several} dismiss={dismiss}>
        <Reason of={first} />
      </Card>
    );
  }
  return (
    <Card title={`${several.length} files could not be opened`} about={several} dismiss={dismiss}>
      <ul class="refused">
        {several.map((refusal) => (
          <li key={refusal.name}>
            <h3>{refusal.name}</h3>
            <Reason of={refusal} />
          </li>
        ))}
      </ul>
    </Card>
  );
}

const titleOf = ({ name }: Refusal) => `${name} could not be opened`;

function Card({
  title,
  about,
  dismiss,
  children,
}: {
  title: string;
  about: readonly Refusal[];
  dismiss: () => void;
  children: ComponentChildren;
}) {
  /** What was copied: another failure can be copied anew. */
  const copied = useSignal<string | null>(null);
  const report = about.map(({ name, failure }) => failureReport(name, failure)).join("\n\n");
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
        <h2>{title}</h2>
        <button type="button" class="button plain icon-only" aria-label="Dismiss" onClick={dismiss}>
          <Icon name="close" />
        </button>
      </div>
      {children}
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
