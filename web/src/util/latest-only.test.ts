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
  call(1);
  call(2);
  call(3);
  expect(started).toEqual([1]);
  finish();
  await vi.waitFor(() => expect(started).toEqual([1, 3]));
});
