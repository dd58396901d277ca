/**
 * Limits an async function to one call at a time. Of the calls made during a call, only the newest
 * runs afterwards, so that a slider does not fill a queue.
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
