import { expect, test } from "vitest";
import type { StoredChanges } from "../batch/batch";
import type { Edit } from "../types";
import {
  isConflict,
  mergeChanges,
  mergeLists,
  nextRecord,
  noChanges,
  parseChanges,
  parseRecord,
  sameChanges,
} from "./stored-changes";

const edit = (start: number, planted = true, side: "left" | "right" = "left"): Edit => ({
  side,
  part: "contact",
  start,
  end: start + 10,
  planted,
});
const changes = (...edits: Edit[]): StoredChanges => ({ edits, names: [] });

test("merges lists that were changed independently", () => {
  const [a, b, c, d] = [edit(0), edit(20), edit(40), edit(60)];
  expect(mergeLists([a], [a], [a, b])).toEqual([a, b]);
  expect(mergeLists([a], [a, c], [a])).toEqual([a, c]);
  expect(mergeLists([a], [a, c], [a, b])).toEqual([a, b, c]);
  expect(mergeLists([a, b, c], [a, c], [a, b, c, d])).toEqual([a, c, d]);
  expect(mergeLists([a], [], [a, b])).toEqual([b]);
  expect(mergeLists([a], [a, b], [])).toEqual([b]);
  expect(mergeLists([], [a, b], [a])).toEqual([a, b]);
});

test("preserves an edit that repeats an earlier one", () => {
  const [on, off] = [edit(0), edit(0, false)];
  expect(mergeLists([on, off], [on, off, on], [on, off])).toEqual([on, off, on]);
  expect(mergeLists([on, off], [on, off, on], [on, off, edit(20)])).toEqual([
    on,
    off,
    edit(20),
    on,
  ]);
});

test("merging is complete in either direction and repeatable", () => {
  const base = changes(edit(0), edit(20));
  const local = changes(edit(0), edit(40));
  const remote = changes(edit(0), edit(20), edit(60));
  const merged = mergeChanges(base, local, remote);
  expect(sameChanges(merged, mergeChanges(base, remote, local))).toBe(true);
  expect(sameChanges(merged, changes(edit(0), edit(40), edit(60)))).toBe(true);
  expect(mergeChanges(remote, merged, remote)).toEqual(merged);
});

test("a name of this page replaces one of the same segment", () => {
  const named = (name: string, start = 0) => ({ start, end: start + 9, name });
  const merged = mergeChanges(
    noChanges,
    { edits: [], names: [named("walk")] },
    { edits: [], names: [named("run"), named("turn", 20)] },
  );
  expect(merged.names).toEqual([named("walk"), named("turn", 20)]);
});

test("edits conflict if they overlap on the same foot", () => {
  const base = changes(edit(0));
  const local = changes(edit(0), edit(20));
  expect(isConflict(base, local, changes(edit(0), edit(25, false)))).toBe(true);
  expect(isConflict(base, local, changes(edit(0), edit(30)))).toBe(false);
  expect(isConflict(base, local, changes(edit(0), edit(25, false, "right")))).toBe(false);
  expect(isConflict(base, base, changes(edit(0, false)))).toBe(false);
  expect(isConflict(base, local, local)).toBe(false);
});

test("records of the first version are read and get a revision", () => {
  const text = JSON.stringify({ version: 1, name: "walk.bvh", edits: [edit(0)], names: [] });
  const read = parseRecord(text);
  expect(read).toEqual(parseRecord(text));
  if (read.kind !== "valid") throw new Error("The record is valid.");
  expect(read.record.edits).toEqual([edit(0)]);
  const next = nextRecord(read.record, "walk.bvh", { ...changes(edit(20)), similarSettled: true });
  expect(next.ancestors).toEqual([read.record.revision]);
  expect(parseRecord(JSON.stringify(next))).toEqual({ kind: "valid", record: next });
});

test("similar plants are not settled in records of versions that did not state it", () => {
  const record = { revision: "a", ancestors: [], name: "walk.bvh", edits: [edit(0)], names: [] };
  const read = (fields: object) => parseRecord(JSON.stringify({ ...record, ...fields }));
  for (const version of [1, 2, 3, 4])
    expect(read({ version, similarSettled: true })).toMatchObject({
      kind: "valid",
      record: { version: 5, similarSettled: false, edits: [edit(0)] },
    });
  expect(read({ version: 5, similarSettled: true })).toMatchObject({
    record: { similarSettled: true },
  });
  expect(read({ version: 5 }).kind).toBe("malformed");
  expect(read({ version: 5, similarSettled: "yes" }).kind).toBe("malformed");
});

test("fields that the schema does not have are dropped", () => {
  const record = { version: 1, name: "", edits: [{ ...edit(0), extra: {} }], names: [], more: 1 };
  expect(parseRecord(JSON.stringify(record))).toMatchObject({ record: { edits: [edit(0)] } });
});

test("reads instants of boundaries, and rejects invalid ones", () => {
  const instant = { side: "left", part: "toe", frame: 10, time: 0.32, uncertainty: 0.01 };
  const read = (instants: unknown) =>
    parseChanges({ edits: [{ ...edit(0), instants }], names: [] })?.edits[0];
  expect(read([{ ...instant, other: 1 }])).toEqual({ ...edit(0), instants: [instant] });
  expect(read(undefined)).toEqual(edit(0));
  for (const field of ["side", "part", "frame", "time", "uncertainty"])
    expect(read([{ ...instant, [field]: null }])).toBeUndefined();
  expect(read(3)).toBeUndefined();
});
