import { expect, test, vi } from "vitest";
import type { ClipSummary } from "../../model/batch/batch";
import { batchRows } from "../../store/batch";
import { ClipSession, openSession } from "../../store/clip-session";
import { createWalkingClip } from "../../testing/walking-clip";

const summarize = vi.fn(() => new Promise(() => {}));

vi.mock("../../engine", async () => ({
  ...(await import("../../testing/fake-engine")),
  batchWorkers: { run: (call: (calls: unknown) => unknown) => call({ summarize }) },
}));

const { refreshOpenRow } = await import("./batch");

test("a processed clip can be saved while it is processed again", async () => {
  vi.useFakeTimers();
  const source = { name: "walk.bvh", data: new Blob() };
  openSession(new ClipSession(createWalkingClip("walk.bvh"), source));
  const summary = { edited: true } as ClipSummary;
  batchRows.value = [{ number: 1, source, status: "done", summary }];
  void refreshOpenRow();
  await vi.runAllTimersAsync();
  expect(summarize).toHaveBeenCalled();
  expect(batchRows.value).toMatchObject([{ status: "done", summary }]);
});
