/** Reading dropped folders. Loaded when one is dropped, without modules that others use: these would load separately. */

import type { ErrorReport } from "../../store/errors";
import type { mapConcurrent } from "../../util/map-concurrent";
import type { DroppedFiles } from "./collect-files";

interface Options {
  /** True for the folders and the files that are read. Dropped files always are. */
  isUsed: (entry: FileSystemEntry) => boolean;
  /** Maximum number of files. */
  maxFiles: number;
  map: typeof mapConcurrent;
}

/** Returns the files of dropped files and folders. What cannot be read is reported, and the rest is opened. */
export async function readFolders(
  entries: readonly FileSystemEntry[],
  { isUsed, maxFiles, map }: Options,
): Promise<DroppedFiles> {
  const found: FileSystemFileEntry[] = [];
  const errors: ErrorReport[] = [];
  const report = ({ fullPath, isDirectory }: FileSystemEntry, error: unknown) =>
    errors.push({
      name: fullPath.slice(1),
      failure: {
        message: `the ${isDirectory ? "folder" : "file"} cannot be read (${textOf(error)})`,
        hint: "Check that it still exists and that you may read it, then drop it again.",
      },
    });
  const queue = [...entries];
  while (queue.length && found.length < maxFiles) {
    const entry = queue.shift();
    if (!entry) break;
    if (entry.isDirectory) {
      const children: FileSystemEntry[] = [];
      try {
        await listFolder(entry as FileSystemDirectoryEntry, children);
      } catch (error) {
        report(entry, error);
      }
      children.sort((a, b) => a.name.localeCompare(b.name, "en", { numeric: true }));
      queue.unshift(...children.filter(isUsed));
    } else found.push(entry as FileSystemFileEntry);
  }
  const files: File[] = [];
  const paths: string[] = [];
  const read = await map(found, (entry) => fileOf(entry).catch((error) => ({ error })));
  for (const [i, entry] of found.entries()) {
    const file = read[i];
    if (file instanceof File) {
      files.push(file);
      paths.push(entry.fullPath.slice(1));
    } else report(entry, file?.error);
  }
  if (queue.length) errors.push(truncatedError(maxFiles));
  if (!files.length && !errors.length) errors.push(emptyError(entries));
  return { files, paths, errors };
}

/** Represents the ignored files in the table. */
const truncatedError = (maxFiles: number): ErrorReport => ({
  name: "More files",
  failure: {
    message: `the folder has more than ${maxFiles} files: the others were ignored`,
    hint: "Drop its subfolders one at a time.",
  },
});

const emptyError = (entries: readonly FileSystemEntry[]): ErrorReport => ({
  name: entries.map(({ name }) => name).join(", "),
  failure: {
    message: `the ${entries.length > 1 ? "folders contain" : "folder contains"} no BVH file`,
  },
});

const textOf = (error: unknown) => (error instanceof Error && error.message) || "unknown error";

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) => entry.file(resolve, reject));
}

/** Adds the entries of a folder to a list; if it cannot be read, those before the failure. */
async function listFolder(folder: FileSystemDirectoryEntry, entries: FileSystemEntry[]) {
  const reader = folder.createReader();
  for (;;) {
    // Returns at most a hundred entries at a time.
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (!batch.length) return;
    entries.push(...batch);
  }
}
