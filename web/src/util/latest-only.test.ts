import { expect, it, vi } from "vitest";
import { latestOnly } from "./latest-only";

it("runs one call at a time and skips all but the newest", async () => {
  const started: number[] = [];
  let finish = () => {};
  const call = latestOnly<number>((value) => {
    started.push(value);
    return new Promise((resolve) => {
      finish = resolve;
    });
  });
  const done = call(1);
  call(2);
  call(3);
  expect(started).toEqual([1]);
  finish();
  await vi.waitFor(() => expect(started).toEqual([1, 3]));
  finish();
  await done;
  call(4);
  expect(started).toEqual([1, 3, 4]);
});

it("runs the newest call after one that fails", async () => {
  const started: number[] = [];
  const call = latestOnly<number>(async (value) => {
    started.push(value);
    if (value === 1) throw new Error("no");
  });
  const failed = expect(call(1)).rejects.toThrow("no");
  call(2);
  await failed;
  await vi.waitFor(() => expect(started).toEqual([1, 2]));
});
