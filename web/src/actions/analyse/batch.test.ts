import { beforeEach, expect, test, vi } from "vitest";
import type { ClipSummary } from "../../model/batch/batch";
import type { Source } from "../../model/sources/source";
import { batchRows } from "../../store/batch";
import { ClipSession, openSession } from "../../store/clip-session";
import { detectOptions } from "../../store/settings";
import { createWalkingClip } from "../../testing/walking-clip";

const never = () => new Promise(() => {});
const summarize = vi.fn((..._: unknown[]): Promise<unknown> => never());

vi.mock("../../engine", async () => ({
  ...(await import("../../testing/fake-engine")),
  batchWorkers: {
    run: (call: (calls: unknown) => Promise<unknown>, signal?: AbortSignal) =>
      Promise.race([
        call({ summarize, commonActions: async () => [] }),
        new Promise((_, reject) => {
          if (signal?.aborted) reject(signal.reason);
          signal?.addEventListener("abort", () => reject(signal.reason));
        }),
      ]),
  },
}));

const { refreshOpenRow, resumeBatch, runBatch, stopBatch } = await import("./batch");

const source = (name: string): Source => ({ name, data: new Blob() });
const summary = { frames: 10, notices: 0, missing: [], edited: false } as Partial<ClipSummary>;
const succeed = async () => ({ ok: true, summary, files: [] });
const statuses = () => batchRows.value.map(({ status }) => status);
/** Names of the processed files, and the methods by which they were processed. */
const processed = () =>
  summarize.mock.calls.map(([, name, request]) => {
    const { detect } = request as { detect: { method: string } };
    return `${name} ${detect.method}`;
  });

beforeEach(() => {
  vi.useFakeTimers();
  stopBatch();
  summarize.mockReset();
  summarize.mockImplementation(never);
  detectOptions.value = { ...detectOptions.value, method: "robust" };
  openSession(new ClipSession(null, null, { isPreview: true }));
});

test("a processed clip can be saved while it is processed again", async () => {
  const source = { name: "walk.bvh", data: new Blob() };
  openSession(new ClipSession(createWalkingClip("walk.bvh"), source));
  const summary = { edited: true } as ClipSummary;
  batchRows.value = [{ number: 1, source, status: "done", summary }];
  void refreshOpenRow();
  await vi.runAllTimersAsync();
  expect(summarize).toHaveBeenCalled();
  expect(batchRows.value).toMatchObject([{ status: "done", summary }]);
});

test("a batch is not resumed while it runs, and can be stopped before its first clip is shown as running", async () => {
  void runBatch([source("walk.bvh"), source("run.bvh")], []);
  void resumeBatch();
  expect(processed()).toEqual(["walk.bvh robust", "run.bvh robust"]);
  stopBatch();
  await vi.runAllTimersAsync();
  expect(statuses()).toEqual(["waiting", "waiting"]);
  summarize.mockImplementation(succeed);
  await resumeBatch();
  expect(statuses()).toEqual(["done", "done"]);
  expect(summarize).toHaveBeenCalledTimes(4);
});
