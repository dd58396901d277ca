/** Reads and writes zip archives. */

import * as Comlink from "comlink";
import { messageOf } from "../model/failure";
import type { Failure, Notice, Result } from "../model/types";
import { crc32 } from "../util/crc32";
import { isMacCompanion } from "../util/file-names";
import { holdLock } from "./hold-lock";
import { readStream } from "./read-blob";
import { listEntries, openEntry, type ZipEntry } from "./zip-reader";
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

export interface UnpackedFile {
  file: File;
  /** Set if the file does not agree with its checksum. */
  notice?: Notice;
}

export interface UnpackedFiles {
  files: UnpackedFile[];
  /** Files that could not be unpacked. */
  errors: { name: string; failure: Failure }[];
}

export type Unpacked = Result<UnpackedFiles>;

const api = {
  holdLock,

  /** Returns the files of an archive whose names have one of the `extensions`. */
  async unpack(
    archive: Blob,
    extensions: readonly string[],
    limits: UnzipLimits,
  ): Promise<Unpacked> {
    try {
      return { ok: true, ...(await unpack(archive, extensions, limits)) };
    } catch (error) {
      if (error instanceof LimitExceeded) return { ok: false, failure: error.failure };
      return {
        ok: false,
        failure: {
          message: `the archive cannot be read (${messageOf(error)})`,
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
): Promise<UnpackedFiles> {
  const entries = (await listEntries(archive)).filter(
    ({ name }) =>
      extensions.some((extension) => name.toLowerCase().endsWith(extension)) &&
      !isMacCompanion(name),
  );
  if (entries.length > limits.files) throw tooManyFiles(limits.files);
  const unpacked: UnpackedFiles = { files: [], errors: [] };
  let remaining = limits.total;
  for (const entry of entries) {
    try {
      const read = await readEntry(archive, entry, (size) => {
        if (size > limits.file) throw tooManyBytes(entry.name, limits.file);
        if (size > remaining) throw tooManyBytes(entry.name, limits.total);
      });
      remaining -= read.file.size;
      unpacked.files.push(read);
    } catch (error) {
      if (error instanceof LimitExceeded) throw error;
      const failure = {
        message: `the file cannot be unpacked from the archive (${messageOf(error)})`,
        hint: "Unpack the archive with another program, and drop the file here.",
      };
      unpacked.errors.push({ name: entry.name, failure });
    }
  }
  return unpacked;
}

/**
 * Unpacks a file and compares it with the checksum in the archive. `checkSize` throws for sizes above
 * the limits.
 */
async function readEntry(
  archive: Blob,
  entry: ZipEntry,
  checkSize: (size: number) => void,
): Promise<UnpackedFile> {
  const { name } = entry;
  // Declared sizes may be too small, but no file is unpacked whose declared size is too large.
  checkSize(entry.size);
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  let crc = 0;
  for await (const chunk of readStream(await openEntry(archive, entry))) {
    size += chunk.length;
    checkSize(size);
    crc = crc32(chunk, crc);
    parts.push(chunk);
  }
  const file = new File(parts, name);
  if (crc === entry.crc && size === entry.size) return { file };
  const notice = {
    code: "archive-checksum",
    text: `The archive states another ${crc === entry.crc ? "size" : "checksum"} for ${name}: the file may be damaged. Pack it again from the original.`,
  };
  return { file, notice };
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
