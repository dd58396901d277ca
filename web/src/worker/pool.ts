/** Several workers that take jobs from one queue, as many as the machine has room for. */

import { isTrap } from "./thread";

/** One that can do a job at a time. */
interface Hand<Calls> {
  calls: Calls;
  stop: () => void;
}

export interface Pool<Calls> {
  /** Does a job when a worker is free. Aborted, it is not begun, or its worker ends. */
  run<T>(job: (calls: Calls) => Promise<T>, signal?: AbortSignal): Promise<T>;
}

interface Job<Calls> {
  work: (calls: Calls) => Promise<unknown>;
  resolve: (value: unknown) => void;
  reject: (reason: unknown) => void;
  signal: AbortSignal | undefined;
}

/** A worker with nothing to do ends after this time: it holds on to its memory until then. */
const patience = 10_000;

/** One processor is left to the page and its own worker; more than four seldom have the memory. */
export const poolSize = () =>
  Math.min(4, Math.max(1, (globalThis.navigator?.hardwareConcurrency ?? 2) - 1));

/** A pool of at most `size` workers that `start` gives; `onBroken` is told of one that fails by itself. */
export function createPool<Calls>(
  start: (onBroken: (reason: Error) => void) => Hand<Calls>,
  size = poolSize(),
): Pool<Calls> {
  const waiting: Job<Calls>[] = [];
  const idle: { hand: Hand<Calls>; end: ReturnType<typeof setTimeout> }[] = [];
  let busy = 0;

  function next() {
    while (waiting.length && busy < size) {
      const job = waiting.shift();
      if (!job) return;
      if (job.signal?.aborted) job.reject(job.signal.reason);
      else void work(job);
    }
  }

  async function work({ work, resolve, reject, signal }: Job<Calls>) {
    busy++;
    let isSound = true;
    let stop: (reason: unknown) => void = () => {};
    const stopped = new Promise<never>((_, rejectAll) => {
      stop = (reason) => {
        isSound = false;
        rejectAll(reason);
      };
    });
    const abort = () => stop(signal?.reason);
    signal?.addEventListener("abort", abort, { once: true });
    const kept = idle.pop();
    clearTimeout(kept?.end);
    // A worker that rests is watched by nobody: the job it did was well done.
    const hand = kept?.hand ?? start((reason) => stop(reason));
    try {
      resolve(await Promise.race([work(hand.calls), stopped]));
    } catch (error) {
      if (isTrap(error)) isSound = false;
      reject(error);
    }
    signal?.removeEventListener("abort", abort);
    if (isSound) rest(hand);
    else hand.stop();
    busy--;
    next();
  }

  function rest(hand: Hand<Calls>) {
    const end = setTimeout(() => {
      idle.splice(
        idle.findIndex((other) => other.hand === hand),
        1,
      );
      hand.stop();
    }, patience);
    idle.push({ hand, end });
  }

  return {
    run: (work, signal) =>
      new Promise((resolve, reject) => {
        const job = { work, resolve: resolve as Job<Calls>["resolve"], reject, signal };
        waiting.push(job);
        next();
      }),
  };
}
