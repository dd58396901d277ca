import { describe, expect, it } from "vitest";
import {
  canReadLeniently,
  excerptWithCaret,
  failureReport,
  locationText,
  noticesReport,
  toSentence,
} from "./report";

it("formats positions", () => {
  expect(locationText({ line: 3, column: 7 })).toBe("line 3, column 7");
  expect(locationText({ line: 3 })).toBe("line 3");
  expect(locationText({})).toBe("");
});

it("turns messages into sentences", () => {
  expect(toSentence("the clip has no motion")).toBe("The clip has no motion.");
  expect(toSentence("Offline.")).toBe("Offline.");
});

it("recognizes failures that lenient reading avoids", () => {
  expect(canReadLeniently({ message: "no number", hint: "Or read the file leniently." })).toBe(
    true,
  );
  expect(canReadLeniently({ message: "no joints" })).toBe(false);
});

describe("excerptWithCaret", () => {
  it("puts the caret under the column", () => {
    expect(excerptWithCaret("0 0 abc 0", 5)).toEqual({ line: "0 0 abc 0", caret: "    ^" });
  });
  it("shortens a long line around the column", () => {
    const long = `${"1.5 ".repeat(100)}bad ${"2.5 ".repeat(100)}`;
    const { line, caret } = excerptWithCaret(long, 401);
    expect(line.length).toBeLessThanOrEqual(66);
    expect(line.slice(caret.length - 1, caret.length + 2)).toBe("bad");
  });
});

it("formats a failure with position, excerpt and hint", () => {
  const text = failureReport("walk.bvh", {
    message: "expected a number",
    line: 9,
    column: 3,
    excerpt: "0 x",
    hint: "Export it again.",
  });
  expect(text).toBe(
    "Plantigrade could not read walk.bvh\nexpected a number\nAt line 9, column 3\n\n  0 x\n    ^\n\nExport it again.",
  );
});

it("formats notices", () => {
  expect(noticesReport("a.bvh", [{ code: "tabs", text: "Tabs.", line: 2 }])).toBe(
    "1 notice on a.bvh\ntabs · line 2 · Tabs.",
  );
});
