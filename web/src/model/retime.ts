/** Frames of one clip (start, end, start, end …) as those of another that begins at the same time. */
export function retimeFrames(intervals: Uint32Array, from: number, to: number): Uint32Array {
  return intervals.map((frame) => Math.round((frame * to) / from));
}
