/**
 * Holds a lock as long as this worker lives, by which the page notices that it has ended. Resolves
 * once the lock is held: to false if the browser does not offer locks to this page.
 */
export function holdLock(name: string): Promise<boolean> {
  return new Promise((resolve) => {
    const hold = () => {
      resolve(true);
      return new Promise<never>(() => {});
    };
    if (!navigator.locks) resolve(false);
    else navigator.locks.request(name, hold).catch(() => resolve(false));
  });
}
