/**
 * Limits an async function to one call at a time. Of the calls made during a call, only the newest
 * runs afterwards, so that a slider does not fill a queue. The promise resolves when no call is left.
 */
export function latestOnly<T>(run: (value: T) => Promise<void>): (value: T) => Promise<void> {
  let waiting: { value: T } | undefined;
  let running: Promise<void> | undefined;
  const runAll = async () => {
    try {
      while (waiting) {
        const { value } = waiting;
        waiting = undefined;
        await run(value);
      }
    } finally {
      running = waiting && runAll();
    }
  };
  return (value) => {
    waiting = { value };
    running ??= runAll();
    return running;
  };
}
