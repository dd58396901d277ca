/** Converts frames from one rate to another, in Hz, rounding to whole frames. */
export function retimeFrames(intervals: Uint32Array, from: number, to: number): Uint32Array {
  return intervals.map((frame) => Math.round((frame * to) / from));
}
