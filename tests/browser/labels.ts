/** Parses files that the app saves. */

import type { SavedFile } from "./app";

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

export const readLabels = ({ text }: SavedFile): Labels => JSON.parse(text);

export interface Table {
  header: string;
  rows: Record<string, string>[];
}

/** Parses a CSV table without quoted fields. */
export function readTable({ text }: SavedFile): Table {
  const [header = "", ...lines] = text.trimEnd().split("\n");
  const names = header.split(",");
  const rows = lines.map((line) => {
    const cells = line.split(",");
    return Object.fromEntries(names.map((name, i) => [name, cells[i] ?? ""]));
  });
  return { header, rows };
}
