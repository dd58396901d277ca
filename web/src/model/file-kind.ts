/** What a file is, by its first bytes: names are often wrong. */
export type FileKind = "clip" | "labels" | "archive";

export async function detectFileKind(file: Blob & { name?: string }): Promise<FileKind> {
  const head = new Uint8Array(await file.slice(0, 512).arrayBuffer());
  // NPZ is an archive too, but one of labels.
  if (head[0] === 0x50 && head[1] === 0x4b && head[2] === 3 && head[3] === 4) {
    return /\.npz$/i.test(file.name ?? "") ? "labels" : "archive";
  }
  const text = new TextDecoder(utf16(head) ?? "utf-8").decode(head).trimStart();
  if (/^hierarchy\b/i.test(text)) return "clip";
  if (/^[{[]/.test(text)) return "labels";
  const [line = ""] = text.split(/\r?\n|\r/, 1);
  if (/(^|,)(left|right)_|(^|,)start(_frame|_s)?(,|$)/.test(line)) return "labels";
  // Whatever else it is, the reader says best what is wrong with it.
  return /\.(json|csv)$/i.test(file.name ?? "") ? "labels" : "clip";
}

/** The name of the UTF-16 whose mark the bytes begin with. */
function utf16([first, second]: Uint8Array): string | undefined {
  if (first === 0xff && second === 0xfe) return "utf-16le";
  if (first === 0xfe && second === 0xff) return "utf-16be";
  return undefined;
}
