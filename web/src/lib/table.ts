/** The table of many clips: its columns, their order, and the table as a file. */

import type { Survey } from "../worker";
import type { Failure } from "../worker/types";
import { centimetres } from "./slides";
import { count, hertz, span } from "./time";

export interface TableRow {
  number: number;
  source: { name: string };
  status: "waiting" | "running" | "done" | "failed";
  survey?: Survey;
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
function found(
  key: string,
  title: string,
  of: (survey: Survey) => number | undefined,
  text: (value: number) => string = count,
  more: Partial<Column> = {},
): Column {
  const value = ({ survey }: TableRow) => (survey ? round(of(survey)) : undefined);
  return {
    key,
    title,
    value,
    text: (row) => {
      const number = value(row);
      return number === undefined ? (row.survey ? "–" : "") : text(number);
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
  found("frames", "Frames", ({ frames }) => frames),
  found("rate_hz", "Rate", ({ rate }) => rate, hertz, { minor: true }),
  found("duration_s", "Length", ({ frames, rate }) => frames / rate, span, { minor: true }),
  found("notices", "Notices", ({ notices }) => notices, count, { minor: true }),
  found("plants", "Plants", ({ plants }) => plants),
  found("left_planted", "Left", ({ planted }) => planted?.left, percent, {
    about: "Share of the frames in which the left foot is planted",
  }),
  found("right_planted", "Right", ({ planted }) => planted?.right, percent, {
    about: "Share of the frames in which the right foot is planted",
  }),
  found(
    "cadence_steps_per_min",
    "Cadence",
    ({ cadence }) => cadence,
    (steps) => steps.toFixed(0),
    {
      about: "Steps per minute",
    },
  ),
  found("mean_slide_m", "Skate", ({ skate }) => skate?.mean, centimetres, {
    about: "How far planted feet slide on the mean",
    minor: true,
  }),
  found("worst_slide_m", "Worst", ({ skate }) => skate?.worst, centimetres, {
    about: "How far a planted foot slides at most",
    minor: true,
  }),
  found("segments", "Segments", ({ segments }) => segments, count, { minor: true }),
  found(
    "took_ms",
    "Time",
    ({ took }) => took,
    (took) => `${(took / 1000).toFixed(2)} s`,
    {
      about: "Time that it took",
      minor: true,
    },
  ),
];

/** Rows in the order of a column; those that have nothing there come last, either way. */
export function sorted<Row extends TableRow>(
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
export function matching<Row extends TableRow>(rows: readonly Row[], words: string): Row[] {
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
    const error = row.failure?.message ?? row.survey?.missing.join("; ") ?? "";
    return [...cells, error].map(field).join(",");
  });
  return [head, ...lines, ""].join("\n");
}

const field = (value: string | number) =>
  /[",\n\r]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value);
