import { commandOf, tooltip } from "../actions/commands";
import { pickFiles } from "../actions/pick-files";
import { openShareDialog } from "../actions/share";
import { batchRows, tableVisible } from "../store/batch";
import { embedded } from "../store/embedded";
import { notices, openClip } from "../store/session";
import { nextTheme, themeChoice } from "../store/theme";
import { dialog } from "../store/view";
import { Icon, Mark } from "../ui/icons";
import { formatCount, formatDuration, formatRate } from "../util/format";
import { MadeWith } from "./MadeWith";

export function Head() {
  return (
    <header class="head">
      <h1 class="brand">
        <Mark />
        {embedded ? "Shared clip" : "Plantigrade"}
      </h1>
      <About />
      <span class="spacer" />
      {embedded && <MadeWith />}
      {batchRows.value.length > 0 && (
        <button
          type="button"
          class="button"
          aria-pressed={tableVisible.value}
          onClick={() => {
            tableVisible.value = !tableVisible.value;
          }}
        >
          {batchRows.value.length} clips
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
        title={tooltip("keys")}
        onClick={commandOf("keys").run}
      >
        ?
      </button>
      {(openClip.value || tableVisible.value) && (
        <button type="button" class="button open-high" title={tooltip("open")} onClick={pickFiles}>
          Open
        </button>
      )}
      {openClip.value && (
        <button
          type="button"
          class="button primary share"
          aria-haspopup="dialog"
          onClick={openShareDialog}
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
    ? [
        `${formatCount(held.frames)} frames`,
        formatRate(held.rate),
        formatDuration(held.frames / held.rate),
      ]
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
