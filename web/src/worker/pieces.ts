/**
 * A file's bytes, one piece after the other.
 *
 * Readers into a buffer of one's own would be quicker, but in Chromium they now and then never answer.
 */
export async function* pieces(file: Blob): AsyncGenerator<Uint8Array> {
  const reader = file.stream().getReader();
  for (let next = await reader.read(); !next.done; next = await reader.read()) yield next.value;
}
