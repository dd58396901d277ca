import { expect, it } from "vitest";
import { each } from "./lanes";

it("does a few at a time and keeps their order", async () => {
  let running = 0;
  let most = 0;
  const numbers = Array.from({ length: 100 }, (_, at) => at);
  const doubled = await each(numbers, async (number) => {
    most = Math.max(most, ++running);
    await new Promise((resolve) => setTimeout(resolve, (number * 7) % 5));
    running--;
    return 2 * number;
  });
  expect(doubled).toEqual(numbers.map((number) => 2 * number));
  expect(most).toBeGreaterThan(1);
  expect(most).toBeLessThan(100);
});

it("fails with the first that does", async () => {
  const failing = each([1, 2, 3], async (number) => {
    if (number === 2) throw new Error("two");
  });
  await expect(failing).rejects.toThrow("two");
  expect(await each([], async () => 1)).toEqual([]);
});
