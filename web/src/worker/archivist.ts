/** Packs and unpacks zip archives, off the page. */

import * as Comlink from "comlink";
import { Unzip, UnzipInflate } from "fflate";
import { Packing } from "./packing";
import type { Failure } from "./types";

/** What an archive is allowed to hold: it is counted as it comes out, whatever the archive says. */
export interface Limits {
  /** Bytes of one file. */
  file: number;
  /** Bytes of all files together. */
  total: number;
  files: number;
}

export type Unpacked = { ok: true; files: File[] } | { ok: false; failure: Failure };

const api = {
  /** The files of an archive whose names end in one of `endings`. */
  async unpack(archive: Blob, endings: readonly string[], limits: Limits): Promise<Unpacked> {
    try {
      return { ok: true, files: await unpack(archive, endings, limits) };
    } catch (error) {
      if (error instanceof TooMuch) return { ok: false, failure: error.failure };
      const reason = error instanceof Error ? error.message : String(error);
      return {
        ok: false,
        failure: {
          message: `the archive cannot be read (${reason})`,
          hint: "Unpack it with another program, and drop its files here.",
        },
      };
    }
  },

  /** Adds a file to the archive that is being packed. */
  async add(name: string, data: string | Uint8Array): Promise<void> {
    packing ??= new Packing();
    packing.add(name, data);
  },

  /** The archive of all that was added. */
  async finish(): Promise<Blob> {
    const packed = (packing ?? new Packing()).finish();
    packing = undefined;
    return packed;
  },
};

export type ArchiveApi = typeof api;

Comlink.expose(api);

/** Bytes of an archive that are unpacked at a time. */
const bite = 2 ** 16;

let packing: Packing | undefined;

class TooMuch extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}

async function unpack(archive: Blob, endings: readonly string[], limits: Limits): Promise<File[]> {
  const files: File[] = [];
  let entries = 0;
  let total = 0;
  const unzip = new Unzip((entry) => {
    if (!endings.some((ending) => entry.name.toLowerCase().endsWith(ending))) return;
    if (/(^|\/)(__MACOSX\/|\._)/.test(entry.name)) return;
    if (++entries > limits.files) throw tooMany(limits.files);
    const parts: Uint8Array<ArrayBuffer>[] = [];
    let size = 0;
    entry.ondata = (error, chunk, isLast) => {
      if (error) throw error;
      size += chunk.length;
      total += chunk.length;
      if (size > limits.file || total > limits.total) {
        entry.terminate();
        throw tooLarge(entry.name, size > limits.file ? limits.file : limits.total);
      }
      parts.push(chunk as Uint8Array<ArrayBuffer>);
      if (isLast) files.push(new File(parts, entry.name));
    };
    entry.start();
  });
  unzip.register(UnzipInflate);
  const reader = archive.stream().getReader();
  for (;;) {
    const { done, value = new Uint8Array(0) } = await reader.read();
    // In small bites: what comes out of one may be a thousand times as much.
    for (let at = 0; at < value.length; at += bite) unzip.push(value.subarray(at, at + bite));
    if (done) break;
  }
  unzip.push(new Uint8Array(0), true);
  return files;
}

const tooMany = (most: number) =>
  new TooMuch({
    message: `the archive has more than ${most} clips`,
    hint: "Unpack it, and drop a part of its files.",
  });

const tooLarge = (name: string, most: number) =>
  new TooMuch({
    message: `the archive unpacks to more than ${Math.round(most / 2 ** 20)} MiB (at ${name})`,
    hint: "If you trust it, unpack it and drop a part of its files.",
  });
