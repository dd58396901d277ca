// @vitest-environment node

import { strToU8, zipSync } from "fflate";
import { expect, test } from "vitest";
import { listEntries, openEntry } from "./zip-reader";

const files = { "a/walk.bvh": strToU8("HIERARCHY".repeat(100)), "b.bvh": strToU8("x") };
const archive = (bytes: Uint8Array<ArrayBufferLike>) => new Blob([bytes.slice()]);
const u32 = (bytes: Uint8Array, at: number) => new DataView(bytes.buffer).getUint32(at, true);

/** Returns the position of the first record with a signature. */
function find(bytes: Uint8Array, signature: number): number {
  for (let at = 0; at + 4 <= bytes.length; at++) if (u32(bytes, at) === signature) return at;
  throw new Error("The archive has no such record.");
}

async function textOf(blob: Blob, name: string): Promise<string> {
  const entry = (await listEntries(blob)).find((entry) => entry.name === name);
  if (!entry) throw new Error(`There is no ${name}.`);
  return new Response(await openEntry(blob, entry)).text();
}

test("reads stored and deflated entries, and a comment at the end", async () => {
  for (const level of [0, 9] as const) {
    const bytes = zipSync(files, { level });
    const blob = archive(new Uint8Array([...bytes, ...new Uint8Array(300)]));
    expect((await listEntries(blob)).map(({ name, size }) => [name, size])).toEqual([
      ["a/walk.bvh", 900],
      ["b.bvh", 1],
    ]);
    expect(await textOf(blob, "a/walk.bvh")).toBe("HIERARCHY".repeat(100));
  }
});

test("reads names in UTF-8 without a flag, and in Latin-1", async () => {
  const bytes = zipSync({ "xx.bvh": strToU8("x") }, { level: 0 });
  const at = find(bytes, 0x02014b50) + 46;
  bytes.set(new TextEncoder().encode("ä"), at);
  expect((await listEntries(archive(bytes)))[0]?.name).toBe("ä.bvh");
  bytes.set([0xe4, 0x78], at);
  expect((await listEntries(archive(bytes)))[0]?.name).toBe("äx.bvh");
});

test("reads sizes and positions of 64 bits", async () => {
  const local = new Uint8Array(30 + 1 + 1);
  new DataView(local.buffer).setUint32(0, 0x04034b50, true);
  local.set([1], 26);
  local.set(strToU8("aX"), 30);
  const central = new Uint8Array(46 + 1 + 28);
  const view = new DataView(central.buffer);
  view.setUint32(0, 0x02014b50, true);
  view.setUint16(28, 1, true);
  view.setUint16(30, 28, true);
  for (const field of [20, 24, 42]) view.setUint32(field, 0xffffffff, true);
  central.set(strToU8("a"), 46);
  view.setUint16(47, 1, true);
  view.setUint16(49, 24, true);
  view.setBigUint64(51, 1n, true);
  view.setBigUint64(59, 1n, true);
  view.setBigUint64(67, 0n, true);
  const end = new Uint8Array(56 + 20 + 22);
  const ends = new DataView(end.buffer);
  ends.setUint32(0, 0x06064b50, true);
  ends.setBigUint64(40, BigInt(central.length), true);
  ends.setBigUint64(48, BigInt(local.length), true);
  ends.setUint32(56, 0x07064b50, true);
  ends.setBigUint64(64, BigInt(local.length + central.length), true);
  ends.setUint32(76, 0x06054b50, true);
  const blob = new Blob([local, central, end]);
  expect(await textOf(blob, "a")).toBe("X");
});

test("refuses damaged archives and entries", async () => {
  const bytes = zipSync(files);
  await expect(listEntries(archive(bytes.subarray(0, 60)))).rejects.toThrow("incomplete");
  const end = find(bytes, 0x06054b50);
  const longDirectory = bytes.slice();
  new DataView(longDirectory.buffer).setUint32(end + 12, 0x7fffffff, true);
  await expect(listEntries(archive(longDirectory))).rejects.toThrow("too long");
  const changed = async (offset: number, value: number) => {
    const copy = bytes.slice();
    copy[find(copy, 0x02014b50) + offset] = value;
    return textOf(archive(copy), "a/walk.bvh");
  };
  await expect(changed(8, 1)).rejects.toThrow("encrypted");
  await expect(changed(10, 12)).rejects.toThrow("method 12");
  await expect(changed(42, 7)).rejects.toThrow("header is damaged");
  await expect(changed(23, 0x70)).rejects.toThrow("incomplete");
});
