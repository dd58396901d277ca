import { useRef } from "preact/hooks";
import { openRow } from "../actions/batch";
import { addCompanion, removeCompanion } from "../actions/companions";
import { toSentence } from "../model/report";
import { columns } from "../model/table";
import type { BatchRow } from "../store/batch";
import { companions, maxCompanions } from "../store/companions";
import { openClip, source } from "../store/session";
import { useVisibleRows } from "../ui/use-visible-rows";

const rowHeight = 40;

const minor = columns.filter((column) => column.minor).length;

/** The rows in sight; the style sheet keeps the room of those above and below. */
export function Rows({ rows }: { rows: readonly BatchRow[] }) {
  const body = useRef<HTMLTableSectionElement>(null);
  const { from, to } = useVisibleRows(body, rowHeight, rows.length);
  return (
    <tbody
      ref={(element) => {
        body.current = element;
        element?.style.setProperty("--above", `${from * rowHeight}px`);
        element?.style.setProperty("--below", `${(rows.length - to) * rowHeight}px`);
      }}
    >
      {rows.slice(from, to).map((row, i) => (
        <tr
          key={row.number}
          aria-rowindex={from + i + 2}
          data-status={row.status}
          data-open={row.source === source.value}
        >
          <Cells row={row} />
        </tr>
      ))}
    </tbody>
  );
}

function Cells({ row }: { row: BatchRow }) {
  const [name, ...others] = columns;
  const why = row.failure?.message ?? row.summary?.missing[0];
  return (
    <>
      <th scope="row">
        <button type="button" title={row.source.name} onClick={() => openRow(row)}>
          {name?.text(row)}
        </button>
        {row.summary?.edited && <span class="muted"> edited</span>}
        {row.summary && openClip.value && row.source !== source.value && <BesideButton row={row} />}
      </th>
      {row.summary ? (
        others.map((column) => (
          <td
            key={column.key}
            data-minor={column.minor}
            title={column.text(row) === "–" ? toSentence(why ?? "") : undefined}
          >
            {column.text(row)}
          </td>
        ))
      ) : (
        <>
          <td class="batch-message" colSpan={others.length - minor} title={why && toSentence(why)}>
            {row.status === "failed" && toSentence(why ?? "")}
            {row.status === "running" && "Labelling…"}
            {row.status === "waiting" && "Waiting"}
          </td>
          <td colSpan={minor} data-minor />
        </>
      )}
    </>
  );
}

/** Puts a clip at the side of the one that is open, or takes it away. */
function BesideButton({ row: { source } }: { row: BatchRow }) {
  const isBeside = companions.value.some((other) => other.source === source);
  return (
    <button
      type="button"
      class="beside"
      aria-label={`${source.name} beside ${openClip.value?.name}`}
      aria-pressed={isBeside}
      disabled={!isBeside && companions.value.length >= maxCompanions}
      title={
        isBeside
          ? "Take it away"
          : companions.value.length < maxCompanions
            ? `Put it beside ${openClip.value?.name}`
            : `No more than ${maxCompanions} stand beside it`
      }
      onClick={() => (isBeside ? removeCompanion(source) : addCompanion(source))}
    >
      Beside
    </button>
  );
}
