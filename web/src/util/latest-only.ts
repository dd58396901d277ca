/**
 * Runs one thing at a time and only the newest of what waits: a slider may call it
 * for every pixel without a queue forming behind the worker.
 */
export function latestOnly<T>(run: (value: T) => Promise<void>): (value: T) => void {
  let busy = false;
  let waiting: { value: T } | undefined;
  const next = async (value: T) => {
    busy = true;
    try {
      await run(value);
    } finally {
      busy = false;
      if (waiting) {
        const { value: newest } = waiting;
        waiting = undefined;
        void next(newest);
      }
    }
  };
  return (value) => {
    if (busy) waiting = { value };
    else void next(value);
  };
}
