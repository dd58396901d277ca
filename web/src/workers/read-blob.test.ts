import { expect, it } from "vitest";
import { readChunks } from "./read-blob";

const bytes = new Uint8Array(3_000_000).map((_, at) => (at * 7) % 251);

async function read(file: Blob): Promise<Buffer> {
  const copies = [];
  for await (const piece of readChunks(file)) copies.push(Buffer.from(piece));
  return Buffer.concat(copies);
}

it("gives all bytes in their order", async () => {
  expect((await read(new Blob([bytes]))).equals(bytes)).toBe(true);
  expect(await read(new Blob([]))).toHaveLength(0);
});

it("does so where the browser lends no buffer", async () => {
  const stream = () =>
    new ReadableStream({
      start(controller) {
        controller.enqueue(bytes.slice(0, 1_000_000));
        controller.enqueue(bytes.slice(1_000_000));
        controller.close();
      },
    });
  expect((await read(Object.assign(new Blob([bytes]), { stream }))).equals(bytes)).toBe(true);
});
