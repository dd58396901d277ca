/** Place of the first of `count` items, in order, that is past something; `count` where none is. */
export function firstIndexWhere(count: number, isPast: (place: number) => boolean): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (isPast(middle)) high = middle;
    else low = middle + 1;
  }
  return low;
}
