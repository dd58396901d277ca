/** Reads a file in chunks, without loading all of it into memory. */

const CHUNK_BYTES = 1 << 20;

/**
 * Readers in use. Chromium may garbage-collect a reader whose result is awaited, so that the
 * promise never settles (about one file in two hundred); a reference prevents that.
 */
const activeReaders = new Set<object>();

/** Yields the chunks of a stream in order; ends the stream when the caller no longer reads. */
export async function* readStream(
  stream: ReadableStream<Uint8Array<ArrayBuffer>>,
): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  const reader = stream.getReader();
  activeReaders.add(reader);
  try {
    for (let next = await reader.read(); !next.done; next = await reader.read()) yield next.value;
  } finally {
    activeReaders.delete(reader);
    await reader.cancel().catch(() => {});
  }
}

/** Maximum size of files that are loaded into memory so that they are read once, in bytes. */
const MAX_LOADED_BYTES = 1 << 25;

/** A file, or its bytes. */
export type FileData = Blob | Uint8Array<ArrayBuffer>;

/** Returns the bytes of a small file, which can then be read several times; a large file is returned itself. */
export async function loadSmall(file: Blob): Promise<FileData> {
  return file.size > MAX_LOADED_BYTES ? file : new Uint8Array(await file.arrayBuffer());
}

/** Returns the size of a file in bytes. */
export const sizeOf = (file: FileData) => (file instanceof Blob ? file.size : file.length);

/** Yields the bytes of a file in order; each chunk may overwrite the previous one. */
export async function* readChunks(file: FileData): AsyncGenerator<Uint8Array> {
  if (!(file instanceof Blob)) {
    yield file;
    return;
  }
  const stream = file.stream();
  let reader: ReadableStreamBYOBReader;
  try {
    reader = stream.getReader({ mode: "byob" });
  } catch {
    // Not all browsers can read into a given buffer.
    yield* readStream(stream);
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
