/** Reads zip archives: their central directory, and single entries as streams. */

/** An entry of the central directory. */
export interface ZipEntry {
  name: string;
  /** Sizes in bytes, and checksum, as the archive states them. */
  compressedSize: number;
  size: number;
  crc: number;
  /** 0 for stored, 8 for deflated. */
  method: number;
  isEncrypted: boolean;
  /** Position of the local header. */
  offset: number;
}

/** Size limit of the central directory: that of half a million short names. */
const maxDirectoryBytes = 2 ** 25;

const signatures = {
  local: 0x04034b50,
  central: 0x02014b50,
  end: 0x06054b50,
  zip64Locator: 0x07064b50,
  zip64End: 0x06064b50,
};

/** Returns the entries of an archive. */
export async function listEntries(archive: Blob): Promise<ZipEntry[]> {
  const { offset, size } = await findDirectory(archive);
  if (size > maxDirectoryBytes) throw new Error("its list of files is too long");
  const view = await viewOf(archive, offset, size);
  const entries: ZipEntry[] = [];
  for (let at = 0; at + 46 <= size && view.getUint32(at, true) === signatures.central; ) {
    const [nameLength, extraLength, commentLength] = [28, 30, 32].map((field) =>
      view.getUint16(at + field, true),
    ) as [number, number, number];
    const end = at + 46 + nameLength + extraLength + commentLength;
    if (end > size) throw new Error("its list of files is damaged");
    entries.push(readEntry(view, at, nameLength, extraLength));
    at = end;
  }
  return entries;
}

/** Returns the position of the central directory. */
async function findDirectory(archive: Blob): Promise<{ offset: number; size: number }> {
  // The end record is followed by a comment of up to 65,535 bytes.
  const tailSize = Math.min(archive.size, 22 + 0xffff);
  const tailStart = archive.size - tailSize;
  const tail = await viewOf(archive, tailStart, tailSize);
  let at = tailSize - 22;
  while (at >= 0 && tail.getUint32(at, true) !== signatures.end) at--;
  if (at < 0) throw new Error("it is incomplete: it has no list of files");
  const found = { size: tail.getUint32(at + 12, true), offset: tail.getUint32(at + 16, true) };
  const hasLocator = at >= 20 && tail.getUint32(at - 20, true) === signatures.zip64Locator;
  if (!hasLocator) return found;
  const end = await viewOf(archive, Number(tail.getBigUint64(at - 12, true)), 56);
  if (end.getUint32(0, true) !== signatures.zip64End) return found;
  return { size: Number(end.getBigUint64(40, true)), offset: Number(end.getBigUint64(48, true)) };
}

function readEntry(view: DataView, at: number, nameLength: number, extraLength: number): ZipEntry {
  const [crc, compressedSize, size, offset] = [16, 20, 24, 42].map((field) =>
    view.getUint32(at + field, true),
  ) as [number, number, number, number];
  const name = new Uint8Array(view.buffer, view.byteOffset + at + 46, nameLength);
  const entry: ZipEntry = {
    name: decodeName(name),
    compressedSize,
    size,
    crc,
    method: view.getUint16(at + 10, true),
    isEncrypted: (view.getUint16(at + 8, true) & 1) !== 0,
    offset,
  };
  readZip64Field(entry, view, at + 46 + nameLength, extraLength);
  return entry;
}

/** Replaces sizes and offset that do not fit into 32 bits by those of the extra field. */
function readZip64Field(entry: ZipEntry, view: DataView, start: number, length: number) {
  const end = start + length;
  for (let at = start; at + 4 <= end; at += 4 + view.getUint16(at + 2, true)) {
    if (view.getUint16(at, true) !== 1) continue;
    let value = at + 4;
    for (const field of ["size", "compressedSize", "offset"] as const) {
      if (entry[field] !== 0xffffffff || value + 8 > end) continue;
      entry[field] = Number(view.getBigUint64(value, true));
      value += 8;
    }
    return;
  }
}

/** Decodes a name as UTF-8, which most programs use without saying so, or else as Latin-1. */
function decodeName(bytes: Uint8Array): string {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("latin1").decode(bytes);
  }
}

/** Returns the uncompressed data of an entry. */
export async function openEntry(
  archive: Blob,
  { method, isEncrypted, offset, compressedSize }: ZipEntry,
): Promise<ReadableStream<Uint8Array<ArrayBuffer>>> {
  if (isEncrypted) throw new Error("it is encrypted");
  if (method !== 0 && method !== 8)
    throw new Error(`its compression (method ${method}) is unknown`);
  const header = await viewOf(archive, offset, 30);
  if (header.getUint32(0, true) !== signatures.local) throw new Error("its header is damaged");
  const start = offset + 30 + header.getUint16(26, true) + header.getUint16(28, true);
  const end = start + compressedSize;
  if (end > archive.size) throw new Error("it is incomplete");
  const data = archive.slice(start, end).stream();
  return method === 0 ? data : data.pipeThrough(new DecompressionStream("deflate-raw"));
}

async function viewOf(archive: Blob, start: number, length: number): Promise<DataView> {
  const buffer = await archive.slice(start, start + length).arrayBuffer();
  if (buffer.byteLength < length) throw new Error("it is incomplete");
  return new DataView(buffer);
}
