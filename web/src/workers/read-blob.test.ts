import { expect, it } from "vitest";
import { readChunks } from "./read-blob";

const bytes = new Uint8Array(3_000_000).map((_, i) => (i * 7) % 251);

async function read(file: Blob): Promise<Buffer> {
  const chunks = [];
  for await (const chunk of readChunks(file)) chunks.push(Buffer.from(chunk));
  return Buffer.concat(chunks);
}

it("yields all bytes in order", async () => {
  expect((await read(new Blob([bytes]))).equals(bytes)).toBe(true);
  expect(await read(new Blob([]))).toHaveLength(0);
});

it("works without support for byte streams", async () => {
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
