/** Kind of a file. */
export type FileKind = "clip" | "labels" | "archive" | "video";

/** Extensions of the files that are used from folders and archives; others are ignored. */
export const extensions = [".bvh", ".json", ".csv", ".npz", ".audacity.txt", ".elan.txt"];

/** Detects the kind of a file from its first bytes, because names are often wrong. */
export async function detectFileKind(file: Blob & { name?: string }): Promise<FileKind> {
  const head = new Uint8Array(await file.slice(0, 512).arrayBuffer());
  // An NPZ file is a zip archive too.
  if (head[0] === 0x50 && head[1] === 0x4b && head[2] === 3 && head[3] === 4) {
    return /\.npz$/i.test(file.name ?? "") ? "labels" : "archive";
  }
  if (isVideo(head)) return "video";
  const text = new TextDecoder(utf16Encoding(head) ?? "utf-8").decode(head).trimStart();
  if (/^hierarchy\b/i.test(text)) return "clip";
  if (/^[{[]/.test(text)) return "labels";
  const [line = ""] = text.split(/\r?\n|\r/, 1);
  if (/(^|,)(left|right)_|(^|,)start(_frame|_s)?(,|$)|^(Tier|-?[\d.]+)\t/.test(line))
    return "labels";
  // The reader of the file reports what is wrong with any other content.
  return /\.(json|csv)$/i.test(file.name ?? "") ? "labels" : "clip";
}

/** Names of the boxes with which files in the formats MP4 and QuickTime begin. */
const boxes = ["ftyp", "moov", "mdat", "wide", "free", "skip"];

/** True for files in the formats MP4, QuickTime, WebM, Matroska, Ogg and AVI, playable or not. */
function isVideo(head: Uint8Array): boolean {
  const text = (start: number, length: number) =>
    String.fromCharCode(...head.subarray(start, start + length));
  const isMatroska = text(0, 4) === "\x1a\x45\xdf\xa3";
  return (
    isMatroska ||
    boxes.includes(text(4, 4)) ||
    text(0, 4) === "OggS" ||
    (text(0, 4) === "RIFF" && text(8, 4) === "AVI ")
  );
}

/** Returns the UTF-16 encoding whose byte order mark the bytes start with. */
function utf16Encoding([first, second]: Uint8Array): string | undefined {
  if (first === 0xff && second === 0xfe) return "utf-16le";
  if (first === 0xfe && second === 0xff) return "utf-16be";
  return undefined;
}
