import { expect, it } from "vitest";
import { mapConcurrent } from "./map-concurrent";

it("runs a limited number of calls at a time and preserves the order", async () => {
  const finish: (() => void)[] = [];
  let running = 0;
  let maxRunning = 0;
  const numbers = Array.from({ length: 100 }, (_, i) => i);
  const mapping = mapConcurrent(numbers, async (number) => {
    maxRunning = Math.max(maxRunning, ++running);
    await new Promise<void>((resolve) => finish.push(resolve));
    running--;
    return 2 * number;
  });
  // The calls finish in reverse order.
  while (running) {
    finish.pop()?.();
    await Promise.resolve();
    await Promise.resolve();
  }
  expect(await mapping).toEqual(numbers.map((number) => 2 * number));
  expect(maxRunning).toBeGreaterThan(1);
  expect(maxRunning).toBeLessThan(100);
});

it("rejects if a call fails", async () => {
  const failing = mapConcurrent([1, 2, 3], async (number) => {
    if (number === 2) throw new Error("two");
  });
  await expect(failing).rejects.toThrow("two");
  expect(await mapConcurrent([], async () => 1)).toEqual([]);
});
