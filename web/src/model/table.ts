/** The table of many clips: its columns, their order, and the table as a file. */

import { formatCount, formatDuration, formatRate } from "../util/format";
import type { ClipSummary } from "./batch";
import { formatCentimetres } from "./slides";
import type { Failure } from "./types";

export interface TableRow {
  number: number;
  source: { name: string };
  status: "waiting" | "running" | "done" | "failed";
  summary?: ClipSummary;
  failure?: Failure;
}

export interface Column {
  key: string;
  title: string;
  /** What the numbers mean, where the title does not say. */
  about?: string;
  /** What rows are sorted by, and what the file says. */
  value: (row: TableRow) => string | number | undefined;
  /** What the page says. */
  text: (row: TableRow) => string;
  /** Left out where there is little room. */
  minor?: boolean;
}

const percent = (share: number | undefined) =>
  share === undefined ? "–" : `${Math.round(100 * share)} %`;

const round = (value: number | undefined, digits = 4) =>
  value === undefined ? undefined : Number(value.toFixed(digits));

/** A column of a number that the survey found. */
function summaryColumn(
  key: string,
  title: string,
  of: (survey: ClipSummary) => number | undefined,
  text: (value: number) => string = formatCount,
  more: Partial<Column> = {},
): Column {
  const value = ({ summary }: TableRow) => (summary ? round(of(summary)) : undefined);
  return {
    key,
    title,
    value,
    text: (row) => {
      const number = value(row);
      return number === undefined ? (row.summary ? "–" : "") : text(number);
    },
    ...more,
  };
}

export const columns: readonly Column[] = [
  {
    key: "file",
    title: "File",
    value: ({ source }) => source.name,
    text: ({ source }) => source.name,
  },
  summaryColumn("frames", "Frames", ({ frames }) => frames),
  summaryColumn("rate_hz", "Rate", ({ rate }) => rate, formatRate, { minor: true }),
  summaryColumn("duration_s", "Length", ({ frames, rate }) => frames / rate, formatDuration, {
    minor: true,
  }),
  summaryColumn("notices", "Notices", ({ notices }) => notices, formatCount, { minor: true }),
  summaryColumn("plants", "Plants", ({ plants }) => plants),
  summaryColumn("left_planted", "Left", ({ planted }) => planted?.left, percent, {
    about: "Share of the frames in which the left foot is planted",
  }),
  summaryColumn("right_planted", "Right", ({ planted }) => planted?.right, percent, {
    about: "Share of the frames in which the right foot is planted",
  }),
  summaryColumn(
    "cadence_steps_per_min",
    "Cadence",
    ({ cadence }) => cadence,
    (steps) => steps.toFixed(0),
    {
      about: "Steps per minute",
    },
  ),
  summaryColumn("mean_slide_m", "Skate", ({ skate }) => skate?.mean, formatCentimetres, {
    about: "How far planted feet slide on the mean",
    minor: true,
  }),
  summaryColumn("worst_slide_m", "Worst", ({ skate }) => skate?.worst, formatCentimetres, {
    about: "How far a planted foot slides at most",
    minor: true,
  }),
  summaryColumn("segments", "Segments", ({ segments }) => segments, formatCount, { minor: true }),
  summaryColumn(
    "took_ms",
    "Time",
    ({ elapsedMs }) => elapsedMs,
    (took) => `${(took / 1000).toFixed(2)} s`,
    {
      about: "Time that it took",
      minor: true,
    },
  ),
];

/** Rows in the order of a column; those that have nothing there come last, either way. */
export function sortRows<Row extends TableRow>(
  rows: readonly Row[],
  key: string,
  direction: 1 | -1,
): Row[] {
  const column = columns.find((other) => other.key === key);
  if (!column) return [...rows];
  return rows.toSorted((a, b) => {
    const [left, right] = [column.value(a), column.value(b)];
    if (left === undefined || right === undefined) {
      return Number(left === undefined) - Number(right === undefined) || a.number - b.number;
    }
    return direction * compare(left, right) || a.number - b.number;
  });
}

function compare(a: string | number, b: string | number): number {
  if (typeof a === "number" && typeof b === "number") return a - b;
  return String(a).localeCompare(String(b), "en", { numeric: true });
}

/** Rows whose name or failure holds all the words. */
export function filterRows<Row extends TableRow>(rows: readonly Row[], words: string): Row[] {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  return rows.filter(({ source, failure, status }) => {
    const text = `${source.name} ${status} ${failure?.message ?? ""}`.toLowerCase();
    return wanted.every((word) => text.includes(word));
  });
}

/** The table with all its columns, and what went wrong. */
export function tableCsv(rows: readonly TableRow[]): string {
  const head = [...columns.map(({ key }) => key), "error"].join(",");
  const lines = rows.map((row) => {
    const cells = columns.map(({ value }) => value(row) ?? "");
    const error = row.failure?.message ?? row.summary?.missing.join("; ") ?? "";
    return [...cells, error].map(field).join(",");
  });
  return [head, ...lines, ""].join("\n");
}

const field = (value: string | number) =>
  /[",\n\r]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value);
