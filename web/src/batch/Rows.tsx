import { useRef } from "preact/hooks";
import { openRow, type Row } from "../app/batch";
import { mostBesides, putBeside, takeAway } from "../app/beside";
import { besides, openClip, source } from "../app/state";
import { sentence } from "../lib/report";
import { columns } from "../lib/table";
import { useSight } from "../lib/useSight";

const rowHeight = 40;

const minor = columns.filter((column) => column.minor).length;

/** The rows in sight; the style sheet keeps the room of those above and below. */
export function Rows({ rows }: { rows: readonly Row[] }) {
  const body = useRef<HTMLTableSectionElement>(null);
  const { from, to } = useSight(body, rowHeight, rows.length);
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

function Cells({ row }: { row: Row }) {
  const [name, ...others] = columns;
  const why = row.failure?.message ?? row.survey?.missing[0];
  return (
    <>
      <th scope="row">
        <button type="button" title={row.source.name} onClick={() => openRow(row)}>
          {name?.text(row)}
        </button>
        {row.survey?.edited && <span class="quiet"> edited</span>}
        {row.survey && openClip.value && row.source !== source.value && <BesideButton row={row} />}
      </th>
      {row.survey ? (
        others.map((column) => (
          <td
            key={column.key}
            data-minor={column.minor}
            title={column.text(row) === "–" ? sentence(why ?? "") : undefined}
          >
            {column.text(row)}
          </td>
        ))
      ) : (
        <>
          <td class="batch-why" colSpan={others.length - minor} title={why && sentence(why)}>
            {row.status === "failed" && sentence(why ?? "")}
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
function BesideButton({ row: { source } }: { row: Row }) {
  const isBeside = besides.value.some((other) => other.source === source);
  return (
    <button
      type="button"
      class="beside"
      aria-label={`${source.name} beside ${openClip.value?.name}`}
      aria-pressed={isBeside}
      disabled={!isBeside && besides.value.length >= mostBesides}
      title={
        isBeside
          ? "Take it away"
          : besides.value.length < mostBesides
            ? `Put it beside ${openClip.value?.name}`
            : `No more than ${mostBesides} stand beside it`
      }
      onClick={() => (isBeside ? takeAway(source) : putBeside(source))}
    >
      Beside
    </button>
  );
}
