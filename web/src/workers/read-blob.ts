/** Reads a file in chunks, without loading all of it into memory. */

const CHUNK_BYTES = 1 << 20;

/**
 * Readers in use. Chromium may garbage-collect a reader whose result is awaited, so that the
 * promise never settles (about one file in two hundred); a reference prevents that.
 */
const activeReaders = new Set<object>();

/** Yields the bytes of a file in order; each chunk may overwrite the previous one. */
export async function* readChunks(file: Blob): AsyncGenerator<Uint8Array> {
  const stream = file.stream();
  let reader: ReadableStreamBYOBReader;
  try {
    reader = stream.getReader({ mode: "byob" });
  } catch {
    yield* readDefault(stream.getReader());
    return;
  }
  activeReaders.add(reader);
  try {
    let buffer = new ArrayBuffer(CHUNK_BYTES);
    for (;;) {
      const { value } = await reader.read(new Uint8Array(buffer));
      if (!value?.length) return;
      yield value;
      buffer = value.buffer;
    }
  } finally {
    activeReaders.delete(reader);
  }
}

/** For browsers that cannot read into a given buffer. */
async function* readDefault(reader: ReadableStreamDefaultReader<Uint8Array>) {
  for (let next = await reader.read(); !next.done; next = await reader.read()) yield next.value;
}
