import type { Failure, Notice } from "./types";

/** Where in a file, in words; empty when nobody knows. */
export function locationText(at: { line?: number; column?: number }): string {
  if (at.line === undefined) return "";
  return at.column === undefined ? `line ${at.line}` : `line ${at.line}, column ${at.column}`;
}

/** A message of the core as a sentence of the page. */
export function toSentence(message: string): string {
  const begun = message.charAt(0).toUpperCase() + message.slice(1);
  return /[.!?]$/.test(begun) ? begun : `${begun}.`;
}

/** Whether a file may open after all if values that are no numbers are passed over. */
export const canReadLeniently = (failure: Failure) => /\bleniently\b/.test(failure.hint ?? "");

/** A window on the offending line with a caret under the column (both count from 1). */
export function excerptWithCaret(excerpt: string, column?: number, width = 64) {
  // A tab would move the caret: one cell each.
  const line = excerpt.replace(/\t/g, " ").trimEnd();
  if (column === undefined) return { line: line.slice(0, width), caret: "" };
  const at = Math.max(0, column - 1);
  const from = line.length <= width ? 0 : Math.max(0, Math.min(at - 24, line.length - width));
  const head = from > 0 ? "…" : "";
  const tail = from + width < line.length ? "…" : "";
  return {
    line: head + line.slice(from, from + width) + tail,
    caret: `${" ".repeat(head.length + Math.max(0, at - from))}^`,
  };
}

/** A failure as text for a bug report or a mail. */
export function failureReport(name: string, failure: Failure): string {
  const lines = [`Plantigrade could not read ${name}`, failure.message];
  const where = locationText(failure);
  if (where) lines.push(`At ${where}`);
  if (failure.excerpt) {
    const { line, caret } = excerptWithCaret(failure.excerpt, failure.column);
    lines.push("", `  ${line}`);
    if (caret) lines.push(`  ${caret}`);
    lines.push("");
  }
  if (failure.hint) lines.push(failure.hint);
  return lines.join("\n");
}

export function noticesReport(name: string, notices: readonly Notice[]): string {
  return [
    `${notices.length} ${notices.length === 1 ? "notice" : "notices"} on ${name}`,
    ...notices.map((n) => [n.code, locationText(n), n.text].filter(Boolean).join(" · ")),
  ].join("\n");
}
