import { commandOf, tooltip } from "../actions/commands";
import { pickFiles } from "../actions/pick-files";
import { openShareDialog } from "../actions/share";
import { batchRows, tableVisible } from "../store/batch";
import { embedded } from "../store/embedded";
import { notices, openClip } from "../store/session";
import { nextTheme, themeChoice } from "../store/theme";
import { dialog } from "../store/view";
import { Icon, Logo } from "../ui/icons";
import { formatCount, formatDuration, formatRate } from "../util/format";
import { MadeWith } from "./MadeWith";

/** The header of the page. */
export function Head() {
  return (
    <header class="head">
      <h1 class="brand">
        <Logo />
        {embedded ? "Shared clip" : "Plantigrade"}
      </h1>
      <ClipSummary />
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
        aria-label={commandOf("keys").label}
        title={tooltip("keys")}
        onClick={commandOf("keys").run}
      >
        ?
      </button>
      {(openClip.value || tableVisible.value) && (
        <button type="button" class="button open-top" title={tooltip("open")} onClick={pickFiles}>
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

/** Name, length, rate and units of the open clip, and the number of notices. */
function ClipSummary() {
  const clip = openClip.value;
  if (!clip) return null;
  const facts = clip.frames
    ? [
        `${formatCount(clip.frames)} frames`,
        formatRate(clip.rate),
        formatDuration(clip.frames / clip.rate),
      ]
    : ["rest pose only"];
  facts.push(`${clip.unit ? `${clip.unit}, ` : ""}${clip.up.replace("-", "−").toUpperCase()} up`);
  const noticeCount = notices.value.length;
  return (
    <p class="clip-summary">
      <strong title={clip.name}>{clip.name}</strong>
      <span class="clip-facts">{facts.join(" · ")}</span>
      {noticeCount > 0 && (
        <button
          type="button"
          class="link"
          aria-haspopup="dialog"
          onClick={() => {
            dialog.value = "notices";
          }}
        >
          {noticeCount} {noticeCount === 1 ? "notice" : "notices"}
        </button>
      )}
    </p>
  );
}
