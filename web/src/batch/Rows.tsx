import { useRef } from "preact/hooks";
import { openRow, toggleChecked } from "../actions/analyse/batch";
import { addCompanion, removeCompanion } from "../actions/open/companions";
import { toSentence } from "../model/batch/report";
import { columns, titleOf } from "../model/batch/table";
import { type BatchRow, openBatchRow, tableFilter } from "../store/batch";
import { maxCompanions, ownCompanions } from "../store/companions";
import { clipTitle, openClip } from "../store/session";
import { Icon } from "../ui/icons";
import { isTouch } from "../ui/touch";
import { useVisibleRows } from "../ui/use-visible-rows";

const rowHeight = isTouch() ? 44 : 40;

const minorCount = columns.filter((column) => column.minor).length;

/** The visible rows; the style sheet reserves the height of the rows above and below. */
export function Rows({ rows }: { rows: readonly BatchRow[] }) {
  const body = useRef<HTMLTableSectionElement>(null);
  const { from, to } = useVisibleRows(body, rowHeight, rows.length);
  return (
    <tbody
      ref={(element) => {
        body.current = element;
        if (!element) return;
        element.onclick = openClickedRow;
        element.style.setProperty("--height-above", `${from * rowHeight}px`);
        element.style.setProperty("--height-below", `${(rows.length - to) * rowHeight}px`);
      }}
    >
      {rows.slice(from, to).map((row, i) => (
        <tr
          key={row.number}
          aria-rowindex={from + i + 2}
          data-number={row.number}
          data-status={row.status}
          data-open={row === openBatchRow.value}
        >
          <Cells row={row} />
        </tr>
      ))}
      {rows.length === 0 && <NoMatch />}
    </tbody>
  );
}

/** States that the filter hides all rows. */
function NoMatch() {
  return (
    <tr>
      <td class="batch-message" colSpan={columns.length - minorCount}>
        No clip matches the filter “{tableFilter}”.{" "}
        <button
          type="button"
          class="button"
          onClick={() => {
            tableFilter.value = "";
          }}
        >
          Show all clips
        </button>
      </td>
      <td colSpan={minorCount} data-minor />
    </tr>
  );
}

/** Presses the name of the row in which a cell was clicked. */
function openClickedRow({ target }: MouseEvent) {
  if (!(target instanceof Element) || target.closest("button, input")) return;
  target.closest("tr")?.querySelector<HTMLElement>(".clip-name")?.click();
}

function Cells({ row }: { row: BatchRow }) {
  const [name, ...others] = columns;
  const problem = row.failure?.message ?? row.summary?.missing[0];
  return (
    <>
      <th scope="row">
        <CheckBox row={row} />
        <button
          type="button"
          class="clip-name"
          aria-label={titleOf(row)}
          title={titleOf(row)}
          onClick={() => openRow(row)}
        >
          <FileName name={name?.text(row) ?? ""} />
        </button>
        {row.summary?.edited && <span class="edited-mark muted">edited</span>}
        {row.summary?.hasUnreadableEdits && <span class="muted"> stored edits cannot be read</span>}
        {row.summary && openClip.value && row !== openBatchRow.value && (
          <SideBySideButton row={row} />
        )}
      </th>
      {row.summary ? (
        others.map((column) => (
          <td
            key={column.key}
            data-key={column.key}
            data-minor={column.minor}
            title={column.text(row) === "–" ? toSentence(problem ?? "") : undefined}
          >
            {column.text(row)}
          </td>
        ))
      ) : (
        <>
          <td
            class="batch-message"
            colSpan={others.length - minorCount}
            title={problem && toSentence(problem)}
          >
            {row.status === "failed" && toSentence(problem ?? "")}
            {row.status === "running" && "Processing…"}
            {row.status === "waiting" && "Waiting"}
          </td>
          <td colSpan={minorCount} data-minor />
        </>
      )}
    </>
  );
}

/** Characters at the end of a file name that are never cut, since names often differ there. */
const endLength = 14;

/** A file name whose middle is left out if space is short. */
function FileName({ name }: { name: string }) {
  const at = Math.max(0, name.length - endLength);
  return (
    <>
      <span class="name-start">{name.slice(0, at)}</span>
      <span class="name-end">{name.slice(at)}</span>
    </>
  );
}

/** Marks a clip as checked. */
function CheckBox({ row }: { row: BatchRow }) {
  if (!row.summary) return null;
  return (
    <input
      type="checkbox"
      aria-label={`${titleOf(row)} is checked`}
      title="Checked"
      checked={row.isChecked ?? false}
      onChange={() => toggleChecked(row)}
    />
  );
}

/** Shows a clip side by side with the open one, or hides it. */
function SideBySideButton({ row }: { row: BatchRow }) {
  const { source } = row;
  const isShown = ownCompanions.value.some((other) => other.source === source);
  return (
    <button
      type="button"
      class="side-by-side"
      aria-label={`${titleOf(row)} side by side with ${clipTitle}`}
      aria-pressed={isShown}
      disabled={!isShown && ownCompanions.value.length >= maxCompanions}
      title={
        isShown
          ? "Remove from the view"
          : ownCompanions.value.length < maxCompanions
            ? `Show side by side with ${clipTitle}`
            : `At most ${maxCompanions} clips can be shown side by side with the open one`
      }
      onClick={() => (isShown ? removeCompanion(source) : addCompanion(source))}
    >
      <Icon name="panel" />
      <span>Side by side</span>
    </button>
  );
}
