/** Reads and writes zip archives. */

import * as Comlink from "comlink";
import { Unzip, UnzipInflate } from "fflate";
import type { Failure, Result } from "../model/types";
import { isMacCompanion } from "../util/file-names";
import { ZipWriter } from "./zip-writer";

/** Limits on the content of an archive; they apply to what is unpacked, not to declared sizes. */
export interface UnzipLimits {
  /** Bytes per file. */
  file: number;
  /** Bytes of all files. */
  total: number;
  /** Number of files. */
  files: number;
}

export type Unpacked = Result<{ files: File[] }>;

const api = {
  /** Returns the files of an archive whose names have one of the `extensions`. */
  async unpack(
    archive: Blob,
    extensions: readonly string[],
    limits: UnzipLimits,
  ): Promise<Unpacked> {
    try {
      return { ok: true, files: await unpack(archive, extensions, limits) };
    } catch (error) {
      if (error instanceof LimitExceeded) return { ok: false, failure: error.failure };
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

  /** Adds a file to the archive that is being written. */
  async add(name: string, data: string | Uint8Array): Promise<void> {
    writer ??= new ZipWriter();
    writer.add(name, data);
  },

  /** Returns the archive of all added files, and starts a new one. */
  async finish(): Promise<Blob> {
    const archive = (writer ?? new ZipWriter()).finish();
    writer = undefined;
    return archive;
  },
};

export type ZipApi = typeof api;

Comlink.expose(api);

/** Bytes that are unpacked at a time; they may expand a thousandfold. */
const chunkBytes = 2 ** 16;

let writer: ZipWriter | undefined;

class LimitExceeded extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}

async function unpack(
  archive: Blob,
  extensions: readonly string[],
  limits: UnzipLimits,
): Promise<File[]> {
  const files: File[] = [];
  let entries = 0;
  let total = 0;
  const unzip = new Unzip((entry) => {
    if (!extensions.some((extension) => entry.name.toLowerCase().endsWith(extension))) return;
    if (isMacCompanion(entry.name)) return;
    if (++entries > limits.files) throw tooManyFiles(limits.files);
    const parts: Uint8Array<ArrayBuffer>[] = [];
    let size = 0;
    entry.ondata = (error, chunk, isLast) => {
      if (error) throw error;
      size += chunk.length;
      total += chunk.length;
      if (size > limits.file || total > limits.total) {
        entry.terminate();
        throw tooManyBytes(entry.name, size > limits.file ? limits.file : limits.total);
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
    for (let at = 0; at < value.length; at += chunkBytes) {
      unzip.push(value.subarray(at, at + chunkBytes));
    }
    if (done) break;
  }
  unzip.push(new Uint8Array(0), true);
  return files;
}

const tooManyFiles = (max: number) =>
  new LimitExceeded({
    message: `the archive has more than ${max} clips`,
    hint: "Unpack it, and drop a part of its files.",
  });

const tooManyBytes = (name: string, max: number) =>
  new LimitExceeded({
    message: `the archive unpacks to more than ${Math.round(max / 2 ** 20)} MiB (at ${name})`,
    hint: "If you trust it, unpack it and drop a part of its files.",
  });
