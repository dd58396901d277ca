/** Reading a file without holding it. */

/** Bytes read at a time. */
const PIECE = 1 << 20;

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
  let buffer = new ArrayBuffer(PIECE);
  for (;;) {
    const { value } = await reader.read(new Uint8Array(buffer));
    if (!value?.length) return;
    yield value;
    buffer = value.buffer;
  }
}

/** Where a browser cannot read into a buffer of ours, each piece is one of its own. */
async function* anew(reader: ReadableStreamDefaultReader<Uint8Array>) {
  for (let next = await reader.read(); !next.done; next = await reader.read()) yield next.value;
}
