import { expect, it } from "vitest";
import { mapConcurrent } from "./map-concurrent";

it("runs a limited number of calls at a time and keeps the order", async () => {
  const finish: (() => void)[] = [];
  let running = 0;
  let most = 0;
  const numbers = Array.from({ length: 100 }, (_, at) => at);
  const mapping = mapConcurrent(numbers, async (number) => {
    most = Math.max(most, ++running);
    await new Promise<void>((resolve) => finish.push(resolve));
    running--;
    return 2 * number;
  });
  // Finished in the reverse of the order in which they were started.
  while (running) {
    finish.pop()?.();
    await Promise.resolve();
    await Promise.resolve();
  }
  expect(await mapping).toEqual(numbers.map((number) => 2 * number));
  expect(most).toBeGreaterThan(1);
  expect(most).toBeLessThan(100);
});

it("rejects if a call fails", async () => {
  const failing = mapConcurrent([1, 2, 3], async (number) => {
    if (number === 2) throw new Error("two");
  });
  await expect(failing).rejects.toThrow("two");
  expect(await mapConcurrent([], async () => 1)).toEqual([]);
});
