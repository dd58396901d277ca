/** The files of a drop. */

import { DownloadError } from "../../model/failure";
import { maxFiles } from "../../model/limits";
import { extensions } from "../../model/sources/file-kind";
import { isMacCompanion } from "../../util/file-names";
import { mapConcurrent } from "../../util/map-concurrent";
import type { DroppedFiles } from "./collect-files";

/** Returns the files of a drop. Must be called synchronously in the event handler. */
export async function filesOfTransfer({ items, files }: DataTransfer): Promise<DroppedFiles> {
  const dropped = [...files];
  const entries = [...items].map((item) => item.webkitGetAsEntry?.() ?? null);
  if (!entries.some((entry) => entry?.isDirectory)) return { files: dropped };
  const { readFolders } = await import("./folders").catch(() => {
    throw new DownloadError("a part of the program could not be loaded");
  });
  const present = entries.filter((entry) => entry !== null);
  return readFolders(present, { isUsed, maxFiles, map: mapConcurrent });
}

const isUsed = ({ name, isDirectory }: FileSystemEntry) =>
  !isMacCompanion(name) &&
  (isDirectory || [...extensions, ".zip"].some((ending) => name.toLowerCase().endsWith(ending)));
