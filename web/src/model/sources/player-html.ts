/**
 * The single-file page: the player, and blocks of inert text that contain its data. The app
 * fills the blocks; the player reads them.
 */

import type { OnProgress } from "../types";

/** Ids of the blocks, in the order of the page; the script of the player follows them. */
export const blockIds = ["title", "enclosed", "clip", "core", "second"] as const;
/** Id of the block with the notices of third-party software, which every page contains. */
export const noticesId = "notices";

export type BlockId = (typeof blockIds)[number];

/**
 * Returns the parts of a page in which some blocks are replaced.
 *
 * @param contents Texts without `<`, or results of `encodeBlock`.
 */
export function fillBlocks(page: string, contents: Partial<Record<BlockId, string | Blob>>) {
  const parts: (string | Blob)[] = [];
  let from = 0;
  for (const block of blockIds) {
    const content = contents[block];
    if (content === undefined) continue;
    if (typeof content === "string" && content.includes("<"))
      throw new Error(`The block "${block}" must not contain "<".`);
    const opening = block === "title" ? "<title>" : ` id="${block}">`;
    const start = page.indexOf(opening, from) + opening.length;
    const end = page.indexOf("</", start);
    if (start < opening.length || end < 0) throw new Error(`The page has no block "${block}".`);
    parts.push(page.slice(from, start), content);
    from = end;
  }
  return [...parts, page.slice(from)];
}

/** Returns an object as JSON for a block, without `<`. */
export const jsonText = (object: object) => JSON.stringify(object).replaceAll("<", "\\u003c");

/** Escapes a text for the title. */
export const titleText = (text: string) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

/** Returns the text of a block of this page; empty if there is no such block. */
export const blockText = (block: BlockId | typeof noticesId) =>
  document.getElementById(block)?.textContent ?? "";

/** Bytes that are encoded at a time: a multiple of three, small enough not to block the page. */
const chunkBytes = 3 * 2 ** 17;

/** Compresses data and encodes it as text for a block. `onProgress` receives 0 to 1. */
export async function encodeBlock(
  data: Blob,
  { signal, onProgress }: { signal?: AbortSignal; onProgress?: OnProgress } = {},
): Promise<Blob> {
  let done = 0;
  const counted = new TransformStream<Uint8Array, Uint8Array<ArrayBuffer>>({
    transform(chunk, controller) {
      signal?.throwIfAborted();
      done += chunk.length;
      onProgress?.(done / data.size);
      controller.enqueue(chunk as Uint8Array<ArrayBuffer>);
    },
  });
  const compressed = data.stream().pipeThrough(counted).pipeThrough(new CompressionStream("gzip"));
  const gzip = await new Response(compressed).blob().catch((error) => {
    // Some browsers report another error for an aborted stream.
    signal?.throwIfAborted();
    throw error;
  });
  const chunks: Blob[] = [];
  for (let start = 0; start < gzip.size; start += chunkBytes) {
    signal?.throwIfAborted();
    chunks.push(new Blob([await base64(gzip.slice(start, start + chunkBytes))]));
  }
  return new Blob(chunks);
}

function base64(data: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result).replace(/^.*,/, ""));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(data);
  });
}

/** Decodes a block of this page that `encodeBlock` has made. */
export async function decodeBlock(block: BlockId): Promise<Blob> {
  const chars = atob(blockText(block));
  const bytes = new Uint8Array(chars.length);
  for (let i = 0; i < chars.length; i++) bytes[i] = chars.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).blob();
}
