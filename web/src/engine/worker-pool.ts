/** A pool of workers that take jobs from one queue. */

import { isFatal } from "../model/failure";

interface PoolWorker<Calls> {
  calls: Calls;
  stop: () => void;
}

export interface Pool<Calls> {
  /** Runs a job on a free worker. If aborted, it is not started, or its worker is stopped. */
  run<T>(job: (calls: Calls) => Promise<T>, signal?: AbortSignal): Promise<T>;
}

interface QueuedJob<Calls> {
  job: (calls: Calls) => Promise<unknown>;
  resolve: (value: unknown) => void;
  reject: (reason: unknown) => void;
  signal: AbortSignal | undefined;
}

/** Time after which an idle worker is stopped to free its memory. */
const idleTimeoutMs = 10_000;

/** Leaves one processor to the page and the clip worker; more than four rarely fit into memory. */
export const poolSize = () =>
  Math.min(4, Math.max(1, (globalThis.navigator?.hardwareConcurrency ?? 2) - 1));

/**
 * Creates a pool of at most `size` workers; `start` starts one and reports its failure to
 * `onBroken`.
 */
export function createPool<Calls>(
  start: (onBroken: (reason: Error) => void) => PoolWorker<Calls>,
  size = poolSize(),
): Pool<Calls> {
  const queue: QueuedJob<Calls>[] = [];
  const idle: { worker: PoolWorker<Calls>; timeout: ReturnType<typeof setTimeout> }[] = [];
  let busy = 0;

  function next() {
    while (queue.length && busy < size) {
      const queued = queue.shift();
      if (!queued) return;
      if (queued.signal?.aborted) queued.reject(queued.signal.reason);
      else void runJob(queued);
    }
  }

  async function runJob({ job, resolve, reject, signal }: QueuedJob<Calls>) {
    busy++;
    let isReusable = true;
    let stop: (reason: unknown) => void = () => {};
    const stopped = new Promise<never>((_, rejectStopped) => {
      stop = (reason) => {
        isReusable = false;
        rejectStopped(reason);
      };
    });
    const abort = () => stop(signal?.reason);
    signal?.addEventListener("abort", abort, { once: true });
    const reused = idle.pop();
    clearTimeout(reused?.timeout);
    const worker = reused?.worker ?? start((reason) => stop(reason));
    try {
      resolve(await Promise.race([job(worker.calls), stopped]));
    } catch (error) {
      if (isFatal(error)) isReusable = false;
      reject(error);
    }
    signal?.removeEventListener("abort", abort);
    if (isReusable) retain(worker);
    else worker.stop();
    busy--;
    next();
  }

  function retain(worker: PoolWorker<Calls>) {
    const timeout = setTimeout(() => {
      idle.splice(
        idle.findIndex((other) => other.worker === worker),
        1,
      );
      worker.stop();
    }, idleTimeoutMs);
    idle.push({ worker, timeout });
  }

  return {
    run: (job, signal) =>
      new Promise((resolve, reject) => {
        queue.push({ job, resolve: resolve as QueuedJob<Calls>["resolve"], reject, signal });
        next();
      }),
  };
}
