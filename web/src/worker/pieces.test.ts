import { expect, it } from "vitest";
import { pieces } from "./pieces";

it("gives all bytes in their order", async () => {
  const bytes = new Uint8Array(3_000_000).map((_, at) => (at * 7) % 251);
  const read = async (file: Blob) => {
    const copies = [];
    for await (const piece of pieces(file)) copies.push(Buffer.from(piece));
    return Buffer.concat(copies);
  };
  expect((await read(new Blob([bytes]))).equals(bytes)).toBe(true);
  expect(await read(new Blob([]))).toHaveLength(0);
});
