/**
 * Returns the first index below `count` for which a predicate is true, or `count`. The predicate
 * must be false up to some index and true from there on.
 */
export function firstIndexWhere(count: number, predicate: (index: number) => boolean): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (predicate(middle)) high = middle;
    else low = middle + 1;
  }
  return low;
}
