import { beforeEach, expect, test, vi } from "vitest";
import type { ClipSummary } from "../../model/batch/batch";
import type { Overrides } from "../../model/types";
import { type BatchRow, batchRequest, batchRows } from "../../store/batch";
import { ClipSession, openSession } from "../../store/clip-session";
import { segmentNames } from "../../store/session";
import { toasts } from "../../store/toasts";
import { createWalkingClip } from "../../testing/walking-clip";

/** Files of the saved archive. */
const saved = new Map<string, string | Uint8Array>();
/** Called when a clip is saved. */
let onSave = async () => {};

const calls = {
  async summarize(_file: Blob, name: string, { vocabulary }: { vocabulary?: object }) {
    await onSave();
    const data = new TextEncoder().encode(`${name} ${vocabulary ? "named" : "unnamed"}`);
    return { ok: true, summary, files: [{ extension: "txt", data }] };
  },
  add: async (name: string, data: string | Uint8Array) => saved.set(name, data),
  finish: async () => new Blob(),
  commonActions: async () => [],
};
const pool = { run: (job: (calls: unknown) => unknown) => job(calls) };

vi.mock("../../engine", async () => ({
  ...(await import("../../testing/fake-engine")),
  batchWorkers: pool,
  zipWorkers: pool,
}));

const { runBatch } = await import("../analyse/batch");
const { exportAll } = await import("./export-batch");

const summary = { frames: 10, rate: 30, notices: 0, missing: [], edited: false, elapsedMs: 1 };
const options = () => ({ detect: { method: "robust", r: 1, w: 1 }, segment: { method: "auto" } });

const rowOf = (name: string, number = 1): BatchRow => ({
  number,
  source: { name, data: new Blob() },
  status: "done",
  summary: summary as ClipSummary,
  actions: new Map([["A", "A"]]),
});

const text = (name: string) => {
  const data = saved.get(name);
  return typeof data === "object" ? new TextDecoder().decode(data) : data;
};

interface Change {
  overrides?: Overrides;
  edited?: boolean;
}

beforeEach(() => {
  saved.clear();
  toasts.value = [];
  onSave = async () => {};
  URL.createObjectURL = () => "blob:";
  vi.spyOn(HTMLAnchorElement.prototype, "click").mockImplementation(() => {});
  openSession(new ClipSession(null, null, { isPreview: true }));
  batchRequest.value = options();
});

test("saves the table from which it was started if the refresh of a row ends after it is replaced", async () => {
  const source = { name: "walk.bvh", data: new Blob() };
  openSession(new ClipSession(createWalkingClip("walk.bvh"), source));
  batchRows.value = [
    { ...rowOf("walk.bvh"), source, summary: { ...summary, edited: true } as ClipSummary },
  ];
  onSave = async () => {
    onSave = async () => {};
    await runBatch([{ name: "other.bvh", data: new Blob() }], []);
  };
  await exportAll();
  expect([...saved.keys()]).toEqual(["walk.txt", "table.csv"]);
  expect(text("table.csv")).toContain("walk.bvh,10");
});

test("saves the table as it is at the start if other files are dropped meanwhile", async () => {
  batchRows.value = [rowOf("walk.bvh", 1), rowOf("run.bvh", 2)];
  onSave = async () => {
    const { actions: _, ...other } = rowOf("other.bvh");
    batchRows.value = [other];
    batchRequest.value = options();
  };
  await exportAll();
  expect([...saved.keys()]).toEqual(["walk.txt", "run.txt", "table.csv"]);
  expect(text("table.csv")).toContain("walk.bvh,10");
  expect(text("table.csv")).toContain("run.bvh,10");
  expect(text("table.csv")).not.toContain("other.bvh");
  expect(text("run.txt")).toBe("run.bvh named");
});

test.each([
  ["settings of the Clip tab", { overrides: { rate: 60 } }, [/^walk\.bvh .*Clip tab/]],
  ["edits that cannot be stored", { edited: true }, [/^walk\.bvh .*edits/]],
  ["nothing", { overrides: { roles: {} } }, []],
])(
  "reports what it does not take from the open clip: %s",
  async (_, { overrides, edited }: Change, texts) => {
    const row = rowOf("walk.bvh");
    batchRows.value = [row, rowOf("run.bvh", 2)];
    const clip = createWalkingClip("walk.bvh");
    openSession(new ClipSession(clip, row.source, { overrides: overrides ?? {} }));
    if (edited) segmentNames.value = [{ start: 0, end: 5, name: "stand" }];
    await exportAll();
    expect(toasts.value.map(({ text }) => text)).toEqual(
      texts.map((text) => expect.stringMatching(text)),
    );
    toasts.value = [];
    batchRows.value = [rowOf("run.bvh")];
    await exportAll();
    expect(toasts.value).toEqual([]);
  },
);
