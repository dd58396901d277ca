/**
 * A page in one file: the player, and in blocks of text that no browser runs what it plays.
 * `fill` puts something into the blocks, `text` and `unpacked` read it in the page.
 */

/** In the order of the page: its own program comes after all of them. */
export const blockIds = ["title", "enclosed", "clip", "core"] as const;
export type BlockId = (typeof blockIds)[number];

/** The page with other contents of some blocks: texts free of `<`, or what was `packed`. */
export function fillBlocks(page: string, contents: Partial<Record<BlockId, string | Blob>>) {
  const parts: (string | Blob)[] = [];
  let from = 0;
  for (const block of blockIds) {
    const content = contents[block];
    if (content === undefined) continue;
    if (typeof content === "string" && content.includes("<"))
      throw new Error(`The ${block} would end too early.`);
    const mark = block === "title" ? "<title>" : ` id="${block}">`;
    const start = page.indexOf(mark, from) + mark.length;
    const end = page.indexOf("</", start);
    if (start < mark.length || end < 0) throw new Error(`The page has no room for the ${block}.`);
    parts.push(page.slice(from, start), content);
    from = end;
  }
  return [...parts, page.slice(from)];
}

/** A record as text of a block: nothing in it can end the block. */
export const jsonText = (record: object) => JSON.stringify(record).replaceAll("<", "\\u003c");

/** Words as text of the title. */
export const titleText = (words: string) =>
  words.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

/** What a block of this page holds; nothing where there is no such block. */
export const blockText = (block: BlockId) => document.getElementById(block)?.textContent ?? "";

/** Bytes that become text at a time: whole groups of three, and few enough for the page to go on. */
const chunkBytes = 3 * 2 ** 17;

/** Bytes as text of a block, as short as can be had; `onProgress` gets the share done, 0 … 1. */
export async function encodeBlock(
  data: Blob,
  { signal, onProgress }: { signal?: AbortSignal; onProgress?: (share: number) => void } = {},
): Promise<Blob> {
  let done = 0;
  const counted = new TransformStream<Uint8Array, Uint8Array<ArrayBuffer>>({
    transform(piece, controller) {
      signal?.throwIfAborted();
      done += piece.length;
      onProgress?.(done / data.size);
      controller.enqueue(piece as Uint8Array<ArrayBuffer>);
    },
  });
  const zipped = data.stream().pipeThrough(counted).pipeThrough(new CompressionStream("gzip"));
  const small = await new Response(zipped).blob().catch((error) => {
    // Some browsers have reasons of their own for a stream that was stopped.
    signal?.throwIfAborted();
    throw error;
  });
  const pieces: Blob[] = [];
  for (let at = 0; at < small.size; at += chunkBytes) {
    signal?.throwIfAborted();
    pieces.push(new Blob([await base64(small.slice(at, at + chunkBytes))]));
  }
  return new Blob(pieces);
}

function base64(data: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result).replace(/^.*,/, ""));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(data);
  });
}

/** The bytes that a block of this page holds. */
export async function decodeBlock(block: BlockId): Promise<Blob> {
  const chars = atob(blockText(block));
  const bytes = new Uint8Array(chars.length);
  for (let i = 0; i < chars.length; i++) bytes[i] = chars.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).blob();
}
