/** Reading a file without holding it. */

/** Bytes read at a time. */
const PIECE = 1 << 20;

/**
 * Readers at work. Chromium does not see that somebody waits for one: without a name here it may
 * be collected with all that waits, and never answers (about one file in two hundred did not).
 */
const working = new Set<object>();

/** A file's bytes, one piece after the other; each may overwrite the one before. */
export async function* pieces(file: Blob): AsyncGenerator<Uint8Array> {
  const stream = file.stream();
  let reader: ReadableStreamBYOBReader;
  try {
    reader = stream.getReader({ mode: "byob" });
  } catch {
    yield* anew(stream.getReader());
    return;
  }
  working.add(reader);
  try {
    let buffer = new ArrayBuffer(PIECE);
    for (;;) {
      const { value } = await reader.read(new Uint8Array(buffer));
      if (!value?.length) return;
      yield value;
      buffer = value.buffer;
    }
  } finally {
    working.delete(reader);
  }
}

/** Where a browser cannot read into a buffer of ours, each piece is one of its own. */
async function* anew(reader: ReadableStreamDefaultReader<Uint8Array>) {
  for (let next = await reader.read(); !next.done; next = await reader.read()) yield next.value;
}
