/** The batch table: its columns, sorting, filtering, and CSV export. */

import { formatCount, formatDuration, formatRate } from "../../util/format";
import { formatCentimetres } from "../plants/slides";
import { titleOfSource } from "../sources/source";
import type { Failure } from "../types";
import type { BatchRequest, ClipSummary } from "./batch";

export interface TableRow {
  number: number;
  source: { name: string; title?: string };
  status: "waiting" | "running" | "done" | "failed";
  summary?: ClipSummary;
  failure?: Failure;
  isChecked?: boolean;
}

export interface Column {
  key: string;
  title: string;
  /** What the values depend on, displayed below the title. */
  detail?: string;
  /** Description, shown as a tooltip. */
  description?: string;
  /** Value for sorting and for the CSV file. */
  value: (row: TableRow) => string | number | undefined;
  /** Displayed text. */
  text: (row: TableRow) => string;
  /** True if the column is hidden on narrow screens. */
  minor?: boolean;
}

/** Returns the name of a clip, with its folder if another clip has the same name. */
export const titleOf = ({ source }: TableRow) => titleOfSource(source);

const percent = (fraction: number) => `${Math.round(100 * fraction)} %`;

const percentTenths = (fraction: number) => `${(100 * fraction).toFixed(1)} %`;

const round = (value: number | undefined, digits = 4) =>
  value === undefined ? undefined : Number(value.toFixed(digits));

/** Creates a column for a number of the summary, which is rounded for the CSV file but not before it is formatted. */
function summaryColumn(
  key: string,
  title: string,
  select: (summary: ClipSummary) => number | undefined,
  format: (value: number) => string = formatCount,
  options: Pick<Column, "description" | "detail" | "minor"> = {},
): Column {
  return {
    key,
    title,
    value: ({ summary }) => summary && round(select(summary)),
    text: ({ summary }) => {
      if (!summary) return "";
      const number = select(summary);
      return number === undefined ? "–" : format(number);
    },
    ...options,
  };
}

export const columns: readonly Column[] = [
  {
    key: "file",
    title: "File",
    value: titleOf,
    text: titleOf,
  },
  summaryColumn("frames", "Frames", ({ frames }) => frames),
  summaryColumn("rate_hz", "Rate", ({ rate }) => rate, formatRate, { minor: true }),
  summaryColumn("duration_s", "Duration", ({ frames, rate }) => frames / rate, formatDuration, {
    minor: true,
  }),
  summaryColumn("notices", "Notices", ({ notices }) => notices, formatCount, { minor: true }),
  summaryColumn("plants", "Plants", ({ plants }) => plants),
  {
    key: "confidence",
    title: "Confidence",
    description: "Confidence of the least certain plant, and the number of plants to review",
    value: ({ summary }) => round(summary?.confidence),
    text: ({ summary }) => {
      if (!summary) return "";
      const { confidence, uncertain = 0 } = summary;
      if (confidence === undefined) return "–";
      const review = uncertain > 0 ? `, ${uncertain} to review` : "";
      return `${Math.floor(100 * confidence)} %${review}`;
    },
  },
  {
    key: "edited",
    title: "Edited",
    description: "Clips whose plants were edited by hand",
    value: ({ summary }) => summary && (summary.edited ? "yes" : "no"),
    text: ({ summary }) => (summary?.edited ? "edited" : ""),
    minor: true,
  },
  summaryColumn("agreement_0_1_s", "Score", ({ agreement }) => agreement, percentTenths, {
    detail: "± 0.1 s",
    description: "Frames that agree with the labels dropped with the clip, within 0.1 s",
    minor: true,
  }),
  summaryColumn("left_planted", "L contact", ({ planted }) => planted?.left, percent, {
    description: "Percentage of frames in which the left foot is planted",
    minor: true,
  }),
  summaryColumn("right_planted", "R contact", ({ planted }) => planted?.right, percent, {
    description: "Percentage of frames in which the right foot is planted",
    minor: true,
  }),
  summaryColumn(
    "cadence_steps_per_min",
    "Cadence",
    ({ cadence }) => cadence,
    (steps) => steps.toFixed(0),
    {
      description: "Steps per minute",
      minor: true,
    },
  ),
  summaryColumn("mean_slide_m", "Mean slide", ({ skate }) => skate?.mean, formatCentimetres, {
    description: "Mean distance that a planted foot slides",
    minor: true,
  }),
  summaryColumn("worst_slide_m", "Max slide", ({ skate }) => skate?.worst, formatCentimetres, {
    description: "Largest distance that a planted foot slides",
    minor: true,
  }),
  summaryColumn("segments", "Segments", ({ segments }) => segments, formatCount, { minor: true }),
  summaryColumn(
    "took_ms",
    "Processing",
    ({ elapsedMs }) => elapsedMs,
    (ms) => `${(ms / 1000).toFixed(2)} s`,
    {
      description: "Processing time of the clip",
      minor: true,
    },
  ),
];

type Options = Pick<BatchRequest, "detect" | "segment">;

/** True if tables of these options have the same values. */
export function haveSameOptions(a: Options, b: Options): boolean {
  const textOf = ({ detect, segment }: Options) =>
    JSON.stringify([detect, segment].map((options) => Object.entries(options).sort()));
  return textOf(a) === textOf(b);
}

/** Sorts rows by a column. Rows without a value come last in both directions. */
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

/** Returns the rows whose name, status, mark or failure contains all words of a query. */
export function filterRows<Row extends TableRow>(rows: readonly Row[], query: string): Row[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  return rows.filter((row) => {
    const { failure, status, isChecked, summary } = row;
    const marks = `${isChecked ? "checked" : "unchecked"} ${summary?.edited ? "edited" : ""}`;
    const text = `${titleOf(row)} ${status} ${marks} ${failure?.message ?? ""}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

/**
 * Returns the table as CSV, with all columns and the columns `error` and `saved_as`: the start of the names of the
 * files that were saved for the row.
 */
export function tableCsv(
  rows: readonly TableRow[],
  savedAs: ReadonlyMap<TableRow, string> = new Map(),
): string {
  const header = [...columns.map(({ key }) => key), "error", "saved_as"].join(",");
  const lines = rows.map((row) => {
    const cells = columns.map(({ value }) => value(row) ?? "");
    const error = row.failure?.message ?? row.summary?.missing.join("; ") ?? "";
    return [...cells, error, savedAs.get(row) ?? ""].map(csvField).join(",");
  });
  return [header, ...lines, ""].join("\n");
}

function csvField(value: string | number): string {
  const text = String(value);
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
