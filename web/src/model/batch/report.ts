import type { Failure, Notice } from "../types";

/** Formats a position in a file: `line 3, column 7`. Empty if it is unknown. */
export function locationText({ line, column }: { line?: number; column?: number }): string {
  if (line === undefined) return "";
  return column === undefined ? `line ${line}` : `line ${line}, column ${column}`;
}

/** Capitalizes a message and ends it with a full stop. */
export function toSentence(message: string): string {
  const capitalized = message.charAt(0).toUpperCase() + message.slice(1);
  return /[.!?]$/.test(capitalized) ? capitalized : `${capitalized}.`;
}

/** True if the file may open when values that are not numbers are replaced. */
export const canReadLeniently = (failure: Failure) => /\bleniently\b/.test(failure.hint ?? "");

/** Returns the part of a line around a column (from 1), and a line with a caret under it. */
export function excerptWithCaret(excerpt: string, column?: number, width = 64) {
  // A tab would misplace the caret.
  const line = excerpt.replace(/\t/g, " ").trimEnd();
  if (column === undefined) return { line: line.slice(0, width), caret: "" };
  const index = Math.max(0, column - 1);
  const from = line.length <= width ? 0 : Math.max(0, Math.min(index - 24, line.length - width));
  const prefix = from > 0 ? "…" : "";
  const suffix = from + width < line.length ? "…" : "";
  return {
    line: prefix + line.slice(from, from + width) + suffix,
    caret: `${" ".repeat(prefix.length + Math.max(0, index - from))}^`,
  };
}

/** Formats a failure as text for a bug report. */
export function failureReport(name: string, failure: Failure): string {
  const lines = [`Plantigrade could not read ${name}`, failure.message];
  const location = locationText(failure);
  if (location) lines.push(`At ${location}`);
  if (failure.excerpt) {
    const { line, caret } = excerptWithCaret(failure.excerpt, failure.column);
    lines.push("", `  ${line}`);
    if (caret) lines.push(`  ${caret}`);
    lines.push("");
  }
  if (failure.hint) lines.push(failure.hint);
  return lines.join("\n");
}

/** Formats notices as text, one per line. */
export function noticesReport(name: string, notices: readonly Notice[]): string {
  return [
    `${notices.length} ${notices.length === 1 ? "notice" : "notices"} on ${name}`,
    ...notices.map((notice) =>
      [notice.code, locationText(notice), notice.text].filter(Boolean).join(" · "),
    ),
  ].join("\n");
}
