import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { createPool, poolSize } from "./worker-pool";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

/** Creates a pool of fake workers that log their start and stop; `breakLast` breaks the newest. */
function fakePool(size: number) {
  const log: string[] = [];
  const breaks: (() => void)[] = [];
  const pool = createPool((onBroken) => {
    const name = String.fromCharCode(97 + breaks.length);
    log.push(`start ${name}`);
    breaks.push(() => onBroken(new Error("broken")));
    return { calls: { name }, stop: () => log.push(`stop ${name}`) };
  }, size);
  return { log, pool, breakLast: () => breaks.at(-1)?.() };
}

const deferred = () => {
  let resolve: (value: string) => void = () => {};
  const promise = new Promise<string>((onResolve) => {
    resolve = onResolve;
  });
  return { promise, resolve };
};

test("uses both of two processors, and leaves one of more to the page", () => {
  expect([1, 2, 3, 4, 5, 32].map((processors) => poolSize(processors))).toEqual([2, 2, 2, 3, 4, 4]);
});

test("starts at most `size` workers and reuses them", async () => {
  const { log, pool } = fakePool(2);
  const jobs = [deferred(), deferred(), deferred()];
  const results = jobs.map((job) => pool.run(async ({ name }) => name + (await job.promise)));
  expect(log).toEqual(["start a", "start b"]);
  jobs[0]?.resolve("0");
  expect(await results[0]).toBe("a0");
  jobs[1]?.resolve("1");
  jobs[2]?.resolve("2");
  expect(await Promise.all(results)).toEqual(["a0", "b1", "a2"]);
  expect(log).toEqual(["start a", "start b"]);
});

test("stops idle workers", async () => {
  const { log, pool } = fakePool(2);
  await pool.run(async () => "");
  await vi.advanceTimersByTimeAsync(9000);
  await pool.run(async () => "");
  await vi.advanceTimersByTimeAsync(9000);
  expect(log).toEqual(["start a"]);
  await vi.advanceTimersByTimeAsync(2000);
  expect(log).toEqual(["start a", "stop a"]);
  await pool.run(async () => "");
  expect(log.at(-1)).toBe("start b");
});

test("stops the worker of an aborted job, or does not start the job", async () => {
  const { log, pool } = fakePool(1);
  const controller = new AbortController();
  const first = pool.run(() => new Promise(() => {}), controller.signal);
  const second = pool.run(async () => "never", controller.signal);
  const third = pool.run(async ({ name }) => name);
  controller.abort(new Error("enough"));
  await expect(first).rejects.toThrow("enough");
  await expect(second).rejects.toThrow("enough");
  expect(await third).toBe("b");
  expect(log).toEqual(["start a", "stop a", "start b"]);
});

test("replaces a worker whose job fails", async () => {
  const { log, pool, breakLast } = fakePool(1);
  await expect(pool.run(() => Promise.reject(new Error("refused")))).rejects.toThrow("refused");
  const broken = pool.run(() => new Promise(() => {}));
  breakLast();
  await expect(broken).rejects.toThrow("broken");
  expect(await pool.run(async ({ name }) => name)).toBe("c");
  expect(log).toEqual(["start a", "stop a", "start b", "stop b", "start c"]);
});

test("ends the job of a reused worker that breaks, and drops an idle one", async () => {
  const { log, pool, breakLast } = fakePool(1);
  await pool.run(async () => "");
  const broken = pool.run(() => new Promise(() => {}));
  breakLast();
  await expect(broken).rejects.toThrow("broken");
  expect(await pool.run(async ({ name }) => name)).toBe("b");
  breakLast();
  expect(await pool.run(async ({ name }) => name)).toBe("c");
  expect(log).toEqual(["start a", "stop a", "start b", "stop b", "start c"]);
});
