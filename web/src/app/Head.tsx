import { hideTable, showTable, uncheckedCount } from "../actions/analyse/batch";
import { commandOf, tooltip } from "../actions/commands";
import { goHome } from "../actions/open/navigation";
import { pickFiles } from "../actions/open/pick-files";
import { openShareDialog } from "../actions/save/share";
import { batchRows, openBatchRow, tableVisible } from "../store/batch";
import { embedded, isHosted } from "../store/embedded";
import { panelCollapsed } from "../store/preferences";
import { clipTitle, edits, notices, openClip } from "../store/session";
import { nextTheme, themeChoice } from "../store/theme";
import { dialog, showTab } from "../store/view";
import { Icon, Logo } from "../ui/icons";
import { formatDuration, formatRate, plural } from "../util/format";
import { MadeWith } from "./MadeWith";

/** The header of the page. */
export function Head() {
  return (
    <header class="head">
      <h1 class="brand">
        {embedded ? (
          <>
            <Logo /> {isHosted ? <span class="visually-hidden">Plantigrade</span> : "Shared clip"}
          </>
        ) : (
          <button
            type="button"
            title="Start page"
            aria-label="Plantigrade, start page"
            onClick={goHome}
          >
            <Logo />
            Plantigrade
          </button>
        )}
      </h1>
      <ClipSummary />
      <span class="spacer" />
      {embedded && !isHosted && <MadeWith />}
      {batchRows.value.length > 0 && (
        <button
          type="button"
          class="button"
          aria-pressed={tableVisible.value}
          onClick={tableVisible.value ? hideTable : showTable}
        >
          {plural(batchRows.value.length, "clip")}
        </button>
      )}
      <Review />
      {/* A page in a frame has the theme of its host. */}
      {!isHosted && (
        <button
          type="button"
          class="button icon-only theme"
          aria-label={`Theme: ${themeChoice.value}`}
          title={`Theme: ${themeChoice.value}`}
          onClick={nextTheme}
        >
          <Icon name={themeChoice.value} />
        </button>
      )}
      <button
        type="button"
        class="button icon-only keys"
        aria-label={commandOf("keys").label}
        title={tooltip("keys")}
        onClick={commandOf("keys").run}
      >
        ?
      </button>
      {(openClip.value || tableVisible.value) && !isHosted && (
        <button
          type="button"
          class="button open-file"
          aria-label="Open"
          title={tooltip("open")}
          onClick={pickFiles}
        >
          <Icon name="open" />
          <span>Open</span>
        </button>
      )}
      {openClip.value && (
        <button
          type="button"
          class="button icon-only toggle-panel"
          aria-label="Panel"
          aria-pressed={!panelCollapsed.value}
          title={tooltip("panel")}
          onClick={commandOf("panel").run}
        >
          <Icon name="panel" />
        </button>
      )}
      {openClip.value && (
        <button
          type="button"
          class={`button ${isHosted ? "" : "primary"} share`}
          aria-haspopup="dialog"
          onClick={openShareDialog}
        >
          Share
        </button>
      )}
    </header>
  );
}

/** Marks the open clip of a batch as checked, and goes to the next one. */
function Review() {
  const row = openBatchRow.value;
  if (!row || tableVisible.value) return null;
  const next = commandOf("review-next");
  return (
    <span class="review">
      <label class="checkbox-row" title={tooltip("mark-checked")}>
        <input
          type="checkbox"
          checked={row.isChecked ?? false}
          onChange={commandOf("mark-checked").run}
        />
        Checked
      </label>
      <button type="button" class="button" title={tooltip("review-next")} onClick={next.run}>
        Next <span class="muted">{uncheckedCount.value}</span>
      </button>
    </span>
  );
}

/** Name, length, rate and units of the open clip, and the number of notices. */
function ClipSummary() {
  const clip = openClip.value;
  if (!clip) return null;
  const facts = clip.frames
    ? [plural(clip.frames, "frame"), formatRate(clip.rate), formatDuration(clip.frames / clip.rate)]
    : ["rest pose only"];
  facts.push(`${clip.unit ? `${clip.unit}, ` : ""}${clip.up.replace("-", "−").toUpperCase()} up`);
  const noticeCount = notices.value.length;
  const title = clipTitle.value;
  const folder = title.slice(0, title.length - clip.name.length);
  return (
    <p class="clip-summary">
      <strong title={title}>
        {folder && <span>{folder}</span>}
        <span>{clip.name}</span>
      </strong>
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
          {plural(noticeCount, "notice")}
        </button>
      )}
      {edits.value.length > 0 && (
        <button
          type="button"
          class="link"
          title="Show the edited plants"
          onClick={() => showTab("labels")}
        >
          edited
        </button>
      )}
    </p>
  );
}
