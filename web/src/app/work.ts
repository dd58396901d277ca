import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { Cancelled, type Stoppable } from "../worker";
import { type Work, work } from "./state";

let count = 0;

/** Lets the worker do what may take long: tells how far it is, and lets a person stop it. */
export async function withProgress<T>(
  about: Pick<Work, "what" | "name">,
  controller: AbortController,
  run: (stoppable: Stoppable) => Promise<T>,
  onStop = () => {},
): Promise<T> {
  const stop = () => {
    controller.abort();
    remove();
    onStop();
  };
  let here: Work = { ...about, id: ++count, stop };
  const remove = () => {
    work.value = work.peek().filter((other) => other !== here);
  };
  work.value = [...work.peek(), here];
  const onProgress = (share: number) => {
    const before = here;
    here = { ...here, share };
    work.value = work.peek().map((other) => (other === before ? here : other));
  };
  try {
    return await run({ signal: controller.signal, onProgress });
  } finally {
    remove();
  }
}

/** Work of one kind for the clip on show, of which only the newest counts. */
export interface Job {
  /** Whether it is being done. */
  busy: ReadonlySignal<boolean>;
  /**
   * Does it in place of what is running, and gives what comes of it; nothing where it was
   * stopped. `onStop` is told when that was by a person.
   */
  run<T>(work: (stoppable: Stoppable) => Promise<T>, onStop: () => void): Promise<T | undefined>;
  /** Ends what nobody waits for any more. */
  stop(): void;
  /** Ends what has run for longer than somebody who wants something else would wait. */
  hurry(): void;
}

/** A job that is told of as `what`; whoever wants another answer waits for `patience` milliseconds. */
export function createJob(what: string, patience: number): Job {
  const running = signal<{ since: number; controller: AbortController } | null>(null);
  const stop = () => {
    running.peek()?.controller.abort();
    running.value = null;
  };
  return {
    busy: computed(() => running.value !== null),
    stop,
    hurry() {
      const here = running.peek();
      // What waits for other work would only make that begin again.
      const first = work.peek().find(({ name }) => name === undefined);
      if (here && first?.what === what && performance.now() - here.since > patience) stop();
    },
    async run(work, onStop) {
      stop();
      const controller = new AbortController();
      const here = { since: performance.now(), controller };
      running.value = here;
      try {
        const made = await withProgress({ what }, controller, work, onStop);
        return running.peek() === here ? made : undefined;
      } catch (error) {
        if (running.peek() !== here || error instanceof Cancelled) return undefined;
        throw error;
      } finally {
        if (running.peek() === here) running.value = null;
      }
    },
  };
}
