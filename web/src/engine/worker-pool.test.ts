import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { createPool } from "./worker-pool";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

/** A pool of hands that write down when they start and stop; `breakLast` breaks the newest. */
function pool(size: number) {
  const said: string[] = [];
  const breaks: (() => void)[] = [];
  const made = createPool((onBroken) => {
    const name = String.fromCharCode(97 + breaks.length);
    said.push(`start ${name}`);
    breaks.push(() => onBroken(new Error("broken")));
    return { calls: { name }, stop: () => said.push(`stop ${name}`) };
  }, size);
  return { said, made, breakLast: () => breaks.at(-1)?.() };
}

const waits = () => {
  let done: (value: string) => void = () => {};
  const promise = new Promise<string>((resolve) => {
    done = resolve;
  });
  return { promise, done };
};

test("no more workers than there is room for, and each is used again", async () => {
  const { said, made } = pool(2);
  const jobs = [waits(), waits(), waits()];
  const results = jobs.map((job) => made.run(async ({ name }) => name + (await job.promise)));
  expect(said).toEqual(["start a", "start b"]);
  jobs[0]?.done("0");
  expect(await results[0]).toBe("a0");
  jobs[1]?.done("1");
  jobs[2]?.done("2");
  expect(await Promise.all(results)).toEqual(["a0", "b1", "a2"]);
  expect(said).toEqual(["start a", "start b"]);
});

test("workers without anything to do end", async () => {
  const { said, made } = pool(2);
  await made.run(async () => "");
  await vi.advanceTimersByTimeAsync(9000);
  await made.run(async () => "");
  await vi.advanceTimersByTimeAsync(9000);
  expect(said).toEqual(["start a"]);
  await vi.advanceTimersByTimeAsync(2000);
  expect(said).toEqual(["start a", "stop a"]);
  await made.run(async () => "");
  expect(said.at(-1)).toBe("start b");
});

test("a job that is aborted ends its worker, or never begins", async () => {
  const { said, made } = pool(1);
  const stop = new AbortController();
  const first = made.run(() => new Promise(() => {}), stop.signal);
  const second = made.run(async () => "never", stop.signal);
  const third = made.run(async ({ name }) => name);
  stop.abort(new Error("enough"));
  await expect(first).rejects.toThrow("enough");
  await expect(second).rejects.toThrow("enough");
  expect(await third).toBe("b");
  expect(said).toEqual(["start a", "stop a", "start b"]);
});

test("a worker that traps or breaks is replaced, one that refuses is not", async () => {
  const { said, made, breakLast } = pool(1);
  await expect(made.run(() => Promise.reject(new Error("refused")))).rejects.toThrow("refused");
  expect(await made.run(async ({ name }) => name)).toBe("a");
  const trap = Object.assign(new Error("unreachable"), { name: "RuntimeError" });
  await expect(made.run(() => Promise.reject(trap))).rejects.toThrow("unreachable");
  const broken = made.run(() => new Promise(() => {}));
  breakLast();
  await expect(broken).rejects.toThrow("broken");
  expect(await made.run(async ({ name }) => name)).toBe("c");
  expect(said).toEqual(["start a", "stop a", "start b", "stop b", "start c"]);
});
