import { count, hertz, span } from "../lib/time";
import { rows, tableShown } from "./batch";
import { enclosed } from "./enclosed";
import { Icon, Mark } from "./icons";
import { MadeWith } from "./MadeWith";
import { askToShare } from "./share";
import { dialog, notices, openClip } from "./state";
import { nextTheme, themeChoice } from "./theme";

export function Head({ pick }: { pick: () => void }) {
  return (
    <header class="head">
      <h1 class="brand">
        <Mark />
        {enclosed ? "Shared clip" : "Plantigrade"}
      </h1>
      <About />
      <span class="spring" />
      {enclosed && <MadeWith />}
      {rows.value.length > 0 && (
        <button
          type="button"
          class="button"
          aria-pressed={tableShown.value}
          onClick={() => {
            tableShown.value = !tableShown.value;
          }}
        >
          {rows.value.length} clips
        </button>
      )}
      <button
        type="button"
        class="button icon-only"
        aria-label={`Theme: ${themeChoice.value}`}
        title={`Theme: ${themeChoice.value}`}
        onClick={nextTheme}
      >
        <Icon name={themeChoice.value} />
      </button>
      <button
        type="button"
        class="button icon-only keys"
        aria-label="Keys"
        title="Keys (?)"
        onClick={() => {
          dialog.value = "keys";
        }}
      >
        ?
      </button>
      {(openClip.value || tableShown.value) && (
        <button type="button" class="button open-high" title="Open (Ctrl O)" onClick={pick}>
          Open
        </button>
      )}
      {openClip.value && (
        <button
          type="button"
          class="button strong share"
          aria-haspopup="dialog"
          onClick={askToShare}
        >
          Share
        </button>
      )}
    </header>
  );
}

/** What is open, in one line. */
function About() {
  const held = openClip.value;
  if (!held) return null;
  const facts = held.frames
    ? [`${count(held.frames)} frames`, hertz(held.rate), span(held.frames / held.rate)]
    : ["rest pose only"];
  facts.push(`${held.unit ? `${held.unit}, ` : ""}${held.up.replace("-", "−").toUpperCase()} up`);
  const heard = notices.value.length;
  return (
    <p class="about">
      <strong title={held.name}>{held.name}</strong>
      <span class="facts-line">{facts.join(" · ")}</span>
      {heard > 0 && (
        <button
          type="button"
          class="link"
          aria-haspopup="dialog"
          onClick={() => {
            dialog.value = "notices";
          }}
        >
          {heard} {heard === 1 ? "notice" : "notices"}
        </button>
      )}
    </p>
  );
}
