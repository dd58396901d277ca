/** Work in progress: the clip that is being opened, and jobs that report progress. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { type CallOptions, Cancelled } from "../engine";

/** The clip that is being opened. */
export interface Opening {
  name: string;
  stage: "fetch" | "read" | "detect";
  /** Completed fraction, 0 to 1; undefined if unknown. */
  fraction?: number;
}

/** A job of a worker that reports progress and can be stopped. */
export interface Job {
  id: number;
  /** Description, to be followed by a name: "Detecting plants in". */
  title: string;
  /** Name of what the job processes; undefined for jobs of the open clip, which end with it. */
  name?: string;
  /** Completed fraction, 0 to 1; undefined if unknown. */
  fraction?: number;
  stop: () => void;
}

export const opening = signal<Opening | null>(null);

/** Running jobs, the oldest first. */
export const jobs = signal<readonly Job[]>([]);

let count = 0;

/** Runs a job, reports its progress in `jobs`, and lets the user stop it. */
export async function runJob<T>(
  { title, name }: Pick<Job, "title" | "name">,
  controller: AbortController,
  call: (options: CallOptions) => Promise<T>,
  onStop = () => {},
): Promise<T> {
  const stop = () => {
    controller.abort();
    remove();
    onStop();
  };
  let job: Job = { title, ...(name !== undefined && { name }), id: ++count, stop };
  const remove = () => {
    jobs.value = jobs.peek().filter((other) => other !== job);
  };
  jobs.value = [...jobs.peek(), job];
  const onProgress = (fraction: number) => {
    const before = job;
    job = { ...job, fraction };
    jobs.value = jobs.peek().map((other) => (other === before ? job : other));
  };
  try {
    return await call({ signal: controller.signal, onProgress });
  } finally {
    remove();
  }
}

/** Stops all jobs of the open clip. */
export function stopClipJobs() {
  for (const { name, stop } of jobs.value) if (name === undefined) stop();
}

/** A kind of job of which at most one runs; starting another one stops it. */
export interface ExclusiveJob {
  /** True while the job runs. */
  busy: ReadonlySignal<boolean>;
  /**
   * Runs the job in place of a running one. Returns undefined if it was stopped; `onStop` is
   * called if the user stopped it.
   */
  run<T>(call: (options: CallOptions) => Promise<T>, onStop: () => void): Promise<T | undefined>;
  stop(): void;
  /** Stops the job if it has run for longer than `maxWaitMs`. */
  stopIfSlow(): void;
}

/** Creates a kind of job. `maxWaitMs` is how long a newer request waits for a running job. */
export function createExclusiveJob(title: string, maxWaitMs: number): ExclusiveJob {
  const running = signal<{ since: number; controller: AbortController } | null>(null);
  const stop = () => {
    running.peek()?.controller.abort();
    running.value = null;
  };
  return {
    busy: computed(() => running.value !== null),
    stop,
    stopIfSlow() {
      const current = running.peek();
      // A job that waits for another one would only have to start again.
      const first = jobs.peek().find(({ name }) => name === undefined);
      const isSlow = current && performance.now() - current.since > maxWaitMs;
      if (isSlow && first?.title === title) stop();
    },
    async run(call, onStop) {
      stop();
      const current = { since: performance.now(), controller: new AbortController() };
      running.value = current;
      try {
        return await runJob({ title }, current.controller, call, onStop);
      } catch (error) {
        if (error instanceof Cancelled) return undefined;
        throw error;
      } finally {
        if (running.peek() === current) running.value = null;
      }
    },
  };
}
