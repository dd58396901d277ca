import { beforeEach, expect, test, vi } from "vitest";
import type { ClipSummary } from "../../model/batch/batch";
import type { Source } from "../../model/sources/source";
import { batchRequest, batchRows } from "../../store/batch";
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

const { openRow, refreshOpenRow, rerunBatch, resumeBatch, retryFailed, runBatch, stopBatch } =
  await import("./batch");

const { errorReport } = await import("../../store/errors");

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

test("a resumed batch and failed files have the options with which the batch was started", async () => {
  summarize.mockImplementationOnce(succeed);
  summarize.mockRejectedValueOnce(new Error("crash"));
  void runBatch([source("walk.bvh"), source("crash.bvh"), source("run.bvh")], []);
  await vi.runAllTimersAsync();
  stopBatch();
  expect(statuses()).toEqual(["done", "failed", "waiting"]);
  detectOptions.value = { ...detectOptions.value, method: "paper" };
  summarize.mockImplementation(succeed);
  await resumeBatch();
  batchRows.value = batchRows.value.map(({ failure, ...row }) => ({
    ...row,
    ...(failure && { failure: { ...failure, canRetry: true } }),
  }));
  await retryFailed();
  const byRobust = ["walk.bvh", "crash.bvh", "run.bvh", "run.bvh", "crash.bvh"];
  expect(processed()).toEqual(byRobust.map((name) => `${name} robust`));
  expect(batchRequest.value?.detect.method).toBe("robust");
  await rerunBatch();
  expect(processed().slice(5)).toEqual(["walk.bvh paper", "crash.bvh paper", "run.bvh paper"]);
  expect(batchRequest.value?.detect.method).toBe("paper");
});

test("a row without a file reports why there is none, and is not processed again", async () => {
  const failure = { message: "no clip of this drop has a matching file name", canRetry: true };
  void runBatch([source("walk.bvh")], [{ name: "odd.json", failure }]);
  const row = batchRows.value[1];
  if (row) expect(await openRow(row)).toBe(false);
  expect(errorReport.value).toMatchObject({
    name: "odd.json",
    failure: { message: failure.message },
  });
  await retryFailed();
  expect(processed()).toEqual(["walk.bvh robust"]);
});

test("the row of the open clip follows its edits while the batch is stopped", async () => {
  const walk = source("walk.bvh");
  summarize.mockImplementationOnce(async () => ({
    ...(await succeed()),
    summary: { ...summary, edited: true },
  }));
  void runBatch([walk, source("run.bvh")], []);
  await vi.runAllTimersAsync();
  stopBatch();
  openSession(new ClipSession(createWalkingClip("walk.bvh"), walk));
  summarize.mockImplementationOnce(async () => ({
    ...(await succeed()),
    summary: { ...summary, plants: 4 },
  }));
  await refreshOpenRow();
  await vi.runAllTimersAsync();
  expect(batchRows.value[0]?.summary?.plants).toBe(4);
});
