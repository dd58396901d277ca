import { expect, it } from "vitest";
import { type FileData, loadSmall, readChunks, sizeOf } from "./read-blob";

const bytes = new Uint8Array(3_000_000).map((_, i) => (i * 7) % 251);

async function read(file: FileData): Promise<Buffer> {
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

it("yields the bytes of a file that is loaded, however often it is read", async () => {
  const loaded = await loadSmall(new Blob([bytes]));
  expect(loaded).toBeInstanceOf(Uint8Array);
  expect(sizeOf(loaded)).toBe(bytes.length);
  for (let time = 0; time < 2; time++) expect((await read(loaded)).equals(bytes)).toBe(true);
  const large = Object.defineProperty(new Blob([bytes]), "size", { value: 1 << 26 });
  expect(await loadSmall(large)).toBe(large);
});
