/** A pool of workers that take jobs from one queue. */

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

/** A worker that is busy or idle. */
interface Slot<Calls> {
  worker: PoolWorker<Calls>;
  /** Called when the worker breaks. */
  onBroken: (reason: Error) => void;
  /** Stops the worker when it has been idle for long. */
  timeout?: ReturnType<typeof setTimeout>;
}

/** Time after which an idle worker is stopped to free its memory. */
const idleTimeoutMs = 10_000;

/**
 * Returns the number of workers for a number of processors. Of two processors the workers use both, as the page
 * needs a tenth of one during a batch; of more, one is left to the page and the clip worker. More than four workers
 * rarely fit into memory.
 */
export const poolSize = (processors = globalThis.navigator?.hardwareConcurrency ?? 2) =>
  Math.min(4, Math.max(2, processors - 1));

/**
 * Creates a pool of at most `size` workers; `start` starts one and reports its failure to
 * `onBroken`.
 */
export function createPool<Calls>(
  start: (onBroken: (reason: Error) => void) => PoolWorker<Calls>,
  size = poolSize(),
): Pool<Calls> {
  const queue: QueuedJob<Calls>[] = [];
  const idle: Slot<Calls>[] = [];
  let busy = 0;

  function next() {
    while (queue.length && busy < size) {
      const queued = queue.shift();
      if (!queued) return;
      if (queued.signal?.aborted) queued.reject(queued.signal.reason);
      else void runJob(queued);
    }
  }

  function startSlot(): Slot<Calls> {
    const slot: Omit<Slot<Calls>, "worker"> = { onBroken: () => {} };
    return Object.assign(slot, { worker: start((reason) => slot.onBroken(reason)) });
  }

  async function runJob({ job, resolve, reject, signal }: QueuedJob<Calls>) {
    busy++;
    let stop: (reason: unknown) => void = () => {};
    const stopped = new Promise<never>((_, rejectStopped) => {
      stop = rejectStopped;
    });
    const abort = () => stop(signal?.reason);
    signal?.addEventListener("abort", abort, { once: true });
    const slot = idle.pop() ?? startSlot();
    clearTimeout(slot.timeout);
    slot.onBroken = stop;
    try {
      resolve(await Promise.race([job(slot.worker.calls), stopped]));
      retain(slot);
    } catch (error) {
      // The worker may be in any state, such as in the middle of an archive.
      slot.worker.stop();
      reject(error);
    }
    signal?.removeEventListener("abort", abort);
    busy--;
    next();
  }

  function retain(slot: Slot<Calls>) {
    const remove = () => {
      clearTimeout(slot.timeout);
      idle.splice(idle.indexOf(slot), 1);
      slot.worker.stop();
    };
    slot.onBroken = remove;
    slot.timeout = setTimeout(remove, idleTimeoutMs);
    idle.push(slot);
  }

  return {
    run: (job, signal) =>
      new Promise((resolve, reject) => {
        queue.push({ job, resolve: resolve as QueuedJob<Calls>["resolve"], reject, signal });
        next();
      }),
  };
}
