/** From what a person drops, picks or pastes to the files in it: folders are walked, archives unpacked. */

import { each } from "../lib/lanes";
import { stemOf } from "../lib/names";
import { sniff } from "../lib/sniff";
import { archivist } from "../worker";
import { messageOf } from "./failing";
import { sizeLimit } from "./limits";
import type { Refusal, Source } from "./state";
import { withProgress } from "./work";

/** What there is to open. */
export interface Gathered {
  clips: Source[];
  /** Labels and segments, to stand beside a clip. */
  labels: Source[];
  refusals: Refusal[];
}

/** Kinds of files in folders and archives that are looked at; others are none of the page's business. */
const endings = [".bvh", ".json", ".csv", ".npz"];

/** More files than this are too many for one table. */
const most = 5000;

/** What comes out of an archive: motion is not packed to a hundredth, but small files may be. */
const limitsOf = (archive: File) => ({
  file: sizeLimit,
  total: Math.min(2 * sizeLimit, Math.max(2 ** 28, 100 * archive.size)),
  files: most,
});

/** Files of a drop; `isCut` where there are more than are taken. */
export interface Files {
  files: File[];
  isCut?: boolean;
}

/** The files of a drop: it has to be asked at once, before it is gone. */
export function filesOf(transfer: DataTransfer): Promise<Files> {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  if (!entries.some((entry) => entry?.isDirectory)) {
    return Promise.resolve({ files: [...transfer.files] });
  }
  return walk(entries.filter((entry) => entry !== null));
}

async function walk(entries: readonly FileSystemEntry[]): Promise<Files> {
  const found: FileSystemFileEntry[] = [];
  const waiting = [...entries].map((entry) => ({ entry, isAsked: true }));
  while (waiting.length && found.length < most) {
    const next = waiting.shift();
    if (!next) break;
    const { entry, isAsked } = next;
    if (entry.isDirectory) {
      const inside = await list(entry as FileSystemDirectoryEntry);
      inside.sort((a, b) => a.name.localeCompare(b.name, "en", { numeric: true }));
      waiting.unshift(...inside.map((entry) => ({ entry, isAsked: false })));
    } else if (isAsked || isKnown(entry.name)) {
      found.push(entry as FileSystemFileEntry);
    }
  }
  return { files: await each(found, fileOf), isCut: waiting.length > 0 };
}

const isKnown = (name: string) =>
  [...endings, ".zip"].some((ending) => name.toLowerCase().endsWith(ending));

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) => entry.file(resolve, reject));
}

async function list(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const found: FileSystemEntry[] = [];
  for (;;) {
    // It gives them a hundred at a time.
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (!some.length) return found;
    found.push(...some);
  }
}

/** Tells clips from labels, and takes archives apart; nothing comes back where a person has stopped it. */
export async function gather({ files, isCut }: Files): Promise<Gathered | undefined> {
  const gathered: Gathered = { clips: [], labels: [], refusals: [] };
  if (isCut) gathered.refusals.push(tooMany);
  // Not one after the other: each would wait for the page to draw itself.
  const kinds = await each(files, sniff);
  for (const [at, file] of files.entries()) {
    const kind = kinds[at] ?? "clip";
    if (kind !== "archive") put(gathered, kind, file);
    else {
      const unpacked = await unpack(file);
      if (!unpacked) return undefined;
      if (Array.isArray(unpacked)) {
        const parts = await each(unpacked, inner);
        for (const [at, part] of unpacked.entries()) put(gathered, parts[at] ?? "clip", part);
      } else gathered.refusals.push(unpacked);
    }
  }
  return gathered;
}

/** Stands in the table for all that was left out. */
const tooMany: Refusal = {
  name: "More files",
  failure: {
    message: `the folder has more than ${most} files: the others were left out`,
    hint: "Drop its folders one by one.",
  },
};

/** Clips with the labels that bear their names; labels of none of them are refused. */
export function withLabels(
  clips: readonly Source[],
  labels: readonly Source[],
): Pick<Gathered, "clips" | "refusals"> {
  const isOf = (clip: Source) => (label: Source) =>
    label.name.toLowerCase().startsWith(`${stemOf(clip.name).toLowerCase()}.`);
  const orphans = labels.filter((label) => !clips.some((clip) => isOf(clip)(label)));
  return {
    clips: clips.map((clip) => ({ ...clip, labels: labels.filter(isOf(clip)) })),
    refusals: orphans.map(({ name }) => ({
      name,
      failure: {
        message: "no clip of this drop bears the name of these labels",
        hint: "Open their clip, and drop them on it.",
      },
    })),
  };
}

/** An archive in an archive is not opened. */
async function inner(file: File) {
  const kind = await sniff(file);
  return kind === "archive" ? "clip" : kind;
}

function put({ clips, labels }: Gathered, kind: "clip" | "labels", file: File) {
  (kind === "clip" ? clips : labels).push({ name: baseOf(file.name), data: file });
}

const baseOf = (path: string) => path.slice(path.lastIndexOf("/") + 1);

async function unpack(archive: File): Promise<File[] | Refusal | undefined> {
  const { name } = archive;
  const controller = new AbortController();
  try {
    const unpacked = await withProgress({ what: "Unpacking", name }, controller, ({ signal }) =>
      archivist.run((calls) => calls.unpack(archive, endings, limitsOf(archive)), signal),
    );
    if (!unpacked.ok) return { name, failure: unpacked.failure };
    if (unpacked.files.length) return unpacked.files;
    return { name, failure: { message: "there is no BVH file in the archive" } };
  } catch (error) {
    if (controller.signal.aborted) return undefined;
    return { name, failure: { message: messageOf(error) } };
  }
}
