/** Videos for tests: the number of each picture is drawn into it as a bar code. */

import type { Page } from "@playwright/test";
import type { Payload } from "./clips";

/** Number of bars, one per bit, and the size of a picture in pixels. */
const bits = 12;
const barWidth = 16;
const size = { width: bits * barWidth, height: 96 } as const;

/** Pictures per cluster of the file; the first is a key frame. */
const pictureGroup = 12;

interface EncodedPicture {
  data: string;
  isKey: boolean;
}

/** Encodes a video in a page; picture i is black and white bars for the bits of i, the highest first. */
export async function encodeVideo(
  page: Page,
  name: string,
  pictures: number,
  rate: number,
): Promise<Payload> {
  const encoded = await page.evaluate(
    async ({ pictures, rate, bits, barWidth, size, pictureGroup }) => {
      const chunks: EncodedPicture[] = [];
      const failures: unknown[] = [];
      const encoder = new VideoEncoder({
        output: (chunk) => {
          const bytes = new Uint8Array(chunk.byteLength);
          chunk.copyTo(bytes);
          const data = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
          chunks.push({ data, isKey: chunk.type === "key" });
        },
        error: (error) => failures.push(error),
      });
      encoder.configure({ codec: "vp8", ...size, bitrate: 1_000_000, framerate: rate });
      const canvas = new OffscreenCanvas(size.width, size.height);
      const ctx = canvas.getContext("2d");
      for (let i = 0; i < pictures; i++) {
        for (let bit = 0; bit < bits; bit++) {
          if (ctx) ctx.fillStyle = (i >> (bits - 1 - bit)) & 1 ? "#fff" : "#000";
          ctx?.fillRect(bit * barWidth, 0, barWidth, size.height);
        }
        const picture = new VideoFrame(canvas, { timestamp: Math.round((i * 1e6) / rate) });
        encoder.encode(picture, { keyFrame: i % pictureGroup === 0 });
        picture.close();
      }
      await encoder.flush();
      if (failures.length) throw failures[0];
      return chunks;
    },
    { pictures, rate, bits, barWidth, size, pictureGroup },
  );
  return { name, mimeType: "video/webm", buffer: webm(encoded, rate) };
}

/** Position of the playhead and number of the picture on show, at one moment. */
export interface Shown {
  frame: number;
  picture: number;
}

/** Returns the frame under the playhead and the picture on show after the next animation frame. */
export async function shownNow(page: Page): Promise<Shown> {
  const [shown] = await shownDuring(page, { until: 0 });
  if (!shown) throw new Error("Nothing is shown.");
  return shown;
}

/**
 * Returns frame and picture each time the playhead has moved, until it has reached a frame: both are then as the
 * browser shows them together.
 */
export function shownDuring(page: Page, { until }: { until: number }): Promise<Shown[]> {
  return page.evaluate(
    async ({ until, bits, barWidth, size }) => {
      const canvas = document.querySelector<HTMLCanvasElement>(".video-picture canvas");
      const playhead = document.querySelector("[role=slider][aria-label=Playhead]");
      const ctx = new OffscreenCanvas(size.width, size.height).getContext("2d", {
        willReadFrequently: true,
      });
      if (!canvas || !playhead || !ctx) throw new Error("There is no video.");
      const read = (): Shown => {
        ctx.drawImage(canvas, 0, 0, size.width, size.height);
        const { data } = ctx.getImageData(0, size.height / 2, size.width, 1);
        let picture = 0;
        for (let bit = 0; bit < bits; bit++) {
          const isWhite = (data[4 * Math.floor((bit + 0.5) * barWidth)] ?? 0) > 127;
          picture = 2 * picture + Number(isWhite);
        }
        return { frame: Number(playhead.getAttribute("aria-valuenow")), picture };
      };
      await new Promise(requestAnimationFrame);
      const shown = [read()];
      if ((shown[0]?.frame ?? 0) >= until) return shown;
      await new Promise<void>((resolve) => {
        const observer = new MutationObserver(() => {
          const now = read();
          shown.push(now);
          if (now.frame < until) return;
          observer.disconnect();
          resolve();
        });
        observer.observe(playhead, { attributeFilter: ["aria-valuenow"] });
      });
      return shown;
    },
    { until, bits, barWidth, size },
  );
}

/** Returns a WebM file with one VP8 track. */
function webm(pictures: readonly EncodedPicture[], rate: number): Buffer {
  const time = (i: number) => Math.round((i * 1000) / rate);
  const text = (value: string) => Buffer.from(value);
  const header = element(
    0x1a45dfa3,
    element(0x4286, uint(1)),
    element(0x42f7, uint(1)),
    element(0x42f2, uint(4)),
    element(0x42f3, uint(8)),
    element(0x4282, text("webm")),
    element(0x4287, uint(2)),
    element(0x4285, uint(2)),
  );
  const duration = Buffer.alloc(8);
  duration.writeDoubleBE(time(pictures.length));
  const info = element(
    0x1549a966,
    element(0x2ad7b1, uint(1_000_000)),
    element(0x4489, duration),
    element(0x4d80, text("test")),
    element(0x5741, text("test")),
  );
  const picture = element(0xe0, element(0xb0, uint(size.width)), element(0xba, uint(size.height)));
  const track = element(
    0xae,
    element(0xd7, uint(1)),
    element(0x73c5, uint(1)),
    element(0x83, uint(1)),
    element(0x86, text("V_VP8")),
    picture,
  );
  const tracks = element(0x1654ae6b, track);
  const groups = Array.from({ length: Math.ceil(pictures.length / pictureGroup) }, (_, group) => {
    const first = group * pictureGroup;
    const blocks = pictures.slice(first, first + pictureGroup).map(({ data, isKey }, i) => {
      const head = Buffer.from([0x81, 0, 0, isKey ? 0x80 : 0]);
      head.writeInt16BE(time(first + i) - time(first), 1);
      return element(0xa3, head, Buffer.from(data, "base64"));
    });
    return {
      time: time(first),
      cluster: element(0x1f43b675, element(0xe7, uint(time(first))), ...blocks),
    };
  });
  // Positions count from the beginning of the segment's content; their width is constant.
  const cuesAt = (start: number) => {
    let position = start;
    const points = groups.map(({ time, cluster }) => {
      const at = position;
      position += cluster.length;
      return element(
        0xbb,
        element(0xb3, uint(time)),
        element(0xb7, element(0xf7, uint(1)), element(0xf1, uint(at))),
      );
    });
    return element(0x1c53bb6b, ...points);
  };
  const start = info.length + tracks.length + cuesAt(0).length;
  const clusters = groups.map(({ cluster }) => cluster);
  return Buffer.concat([header, element(0x18538067, info, tracks, cuesAt(start), ...clusters)]);
}

/** Returns an element of EBML: its identifier, its size in eight bytes, and its content. */
function element(id: number, ...content: Buffer[]): Buffer {
  const data = Buffer.concat(content);
  const length = Buffer.alloc(8);
  length.writeBigUInt64BE(BigInt(data.length) | (1n << 56n));
  return Buffer.concat([Buffer.from(hexadecimal(id), "hex"), length, data]);
}

function hexadecimal(id: number): string {
  const text = id.toString(16);
  return text.length % 2 ? `0${text}` : text;
}

/** Returns a number in four bytes. */
function uint(value: number): Buffer {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32BE(value);
  return bytes;
}
