/** Reads what the app saves. */

import type { Saved } from "./app";

export interface Span {
  start: number;
  end: number;
  start_s: number;
  end_s: number;
  source: string;
}

type Foot = Record<"contact" | "heel" | "toe", Span[] | undefined>;

export interface Labels {
  format: string;
  version: number;
  source: { name: string; sha256: string };
  frames: number;
  rate: number;
  joints: Record<"left" | "right", { heel: string; toe: string }>;
  method: { name: string; r: number; w: number };
  left: Foot;
  right: Foot;
}

export const readLabels = ({ text }: Saved): Labels => JSON.parse(text);

export interface Table {
  head: string;
  rows: Record<string, string>[];
}

/** Rows by the names of their columns; none of our tables quotes a field here. */
export function readTable({ text }: Saved): Table {
  const [head = "", ...lines] = text.trimEnd().split("\n");
  const names = head.split(",");
  const rows = lines.map((line) => {
    const cells = line.split(",");
    return Object.fromEntries(names.map((name, i) => [name, cells[i] ?? ""]));
  });
  return { head, rows };
}
