/** Collects the files of a drop: reads folders, unpacks archives, and separates clips from labels. */

import { zipWorkers } from "../../engine";
import { failureOf } from "../../model/failure";
import { maxFileBytes, maxFiles } from "../../model/limits";
import { detectFileKind, extensions } from "../../model/sources/file-kind";
import type { Source } from "../../model/sources/source";
import type { Failure, Notice } from "../../model/types";
import type { ErrorReport } from "../../store/errors";
import { runJob } from "../../store/jobs";
import { baseNameOf, stemOf } from "../../util/file-names";
import { mapConcurrent } from "../../util/map-concurrent";
import type { UnpackedFiles } from "../../workers/zip.worker";

export interface CollectedFiles {
  clips: Source[];
  /** Reference labels and segments. */
  labels: Source[];
  videos: File[];
  errors: ErrorReport[];
}

/** Limits on what an archive unpacks to. Motion compresses less than a hundredfold. */
const limitsOf = (archive: File) => ({
  file: maxFileBytes,
  total: Math.min(2 * maxFileBytes, Math.max(2 ** 28, 100 * archive.size)),
  files: maxFiles,
});

/** The files of a drop. */
export interface DroppedFiles {
  files: File[];
  /** Path of each file; by default, its name. */
  paths?: readonly string[];
  /** Files and folders that could not be read, and those that were ignored. */
  errors?: readonly ErrorReport[];
}

/** Sorts files by kind and unpacks archives. Returns undefined if the user stopped that. */
export async function collectFiles({
  files,
  paths,
  errors = [],
}: DroppedFiles): Promise<CollectedFiles | undefined> {
  const collected: CollectedFiles = { clips: [], labels: [], videos: [], errors: [...errors] };
  // Concurrently, because each file would otherwise wait for the page to render.
  const kinds = await mapConcurrent(files, kindOf);
  for (const [i, file] of files.entries()) {
    const kind = kinds[i] ?? "clip";
    const path = paths?.[i] ?? file.name;
    if (kind !== "archive") addFile(collected, kind, file, path);
    else {
      const unpacked = await unpack(file);
      if (!unpacked) return undefined;
      collected.errors.push(...unpacked.errors);
      const innerKinds = await mapConcurrent(unpacked.files, ({ file }) => innerFileKind(file));
      // Several archives may contain files of the same path.
      const folder = files.length > 1 ? `${path}/` : "";
      for (const [i, { file, notice }] of unpacked.files.entries()) {
        addFile(collected, innerKinds[i] ?? "clip", file, folder + file.name, notice && [notice]);
      }
    }
  }
  return collected;
}

/**
 * Attaches each file of labels to the clip with the longest name that its name starts with, in the same folder or
 * else in any other. Files of no or of several such clips are errors. Clips of the same name get titles.
 */
export function attachLabels(
  clips: readonly Source[],
  labels: readonly Source[],
  place = "this drop",
): Pick<CollectedFiles, "clips" | "errors"> {
  const stems = clips.map(({ name }) => `${stemOf(name)}.`.toLowerCase());
  const attached = clips.map(() => [] as Source[]);
  const errors: ErrorReport[] = [];
  for (const label of labels) {
    const name = label.name.toLowerCase();
    let matching = [...clips.keys()].filter((i) => name.startsWith(stems[i] ?? ""));
    const isNear = (i: number) => clips[i]?.folder === label.folder;
    if (matching.some(isNear)) matching = matching.filter(isNear);
    const lengthOf = (i: number) => stems[i]?.length ?? 0;
    const longest = Math.max(...matching.map(lengthOf));
    const [owner, ...others] = matching.filter((i) => lengthOf(i) === longest);
    if (owner !== undefined && !others.length) attached[owner]?.push(label);
    else {
      const [clips, have] = others.length ? ["several clips", "have"] : ["no clip", "has"];
      const message = `${clips} of ${place} ${have} a matching file name`;
      const hint = "Open the clip, then drop this file.";
      errors.push({ name: label.name, failure: { message, hint } });
    }
  }
  const names = new Set<string>();
  const repeated = new Set<string>();
  for (const { name } of clips) (names.has(name) ? repeated : names).add(name);
  return {
    clips: clips.map((clip, i) => ({
      ...clip,
      labels: attached[i] ?? [],
      ...(repeated.has(clip.name) && { title: `${clip.folder}${clip.name}` }),
    })),
    errors,
  };
}

/** Like `detectFileKind`; the reader reports why a file cannot be read. */
const kindOf = (file: File) => detectFileKind(file).catch(() => "clip" as const);

/** Like `detectFileKind`, but archives in archives are not opened. */
async function innerFileKind(file: File) {
  const kind = await detectFileKind(file);
  return kind === "archive" ? "clip" : kind;
}

function addFile(
  { clips, labels, videos }: CollectedFiles,
  kind: "clip" | "labels" | "video",
  file: File,
  path: string,
  notices: readonly Notice[] = [],
) {
  if (kind === "video") {
    videos.push(file);
    return;
  }
  const list = kind === "clip" ? clips : labels;
  const name = baseNameOf(path);
  list.push({ name, folder: path.slice(0, path.length - name.length), data: file, notices });
}

async function unpack(archive: File): Promise<UnpackedFiles | undefined> {
  const { name } = archive;
  const controller = new AbortController();
  const failed = (failure: Failure) => ({ files: [], errors: [{ name, failure }] });
  try {
    const unpacked = await runJob({ title: "Unpacking", name }, controller, ({ signal }) =>
      zipWorkers.run((calls) => calls.unpack(archive, extensions, limitsOf(archive)), signal),
    );
    if (!unpacked.ok) return failed(unpacked.failure);
    if (unpacked.files.length || unpacked.errors.length) return unpacked;
    return failed({ message: "the archive contains no BVH file" });
  } catch (error) {
    if (controller.signal.aborted) return undefined;
    return failed(failureOf(error));
  }
}
