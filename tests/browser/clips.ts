/** Clips for tests: samples, valid and invalid files, and recorded motion if it is available. */

import { existsSync, readFileSync } from "node:fs";
import { basename, join } from "node:path";

export const root = join(import.meta.dirname, "../..");

export interface Payload {
  name: string;
  mimeType: string;
  buffer: Buffer;
}

/** Returns a file of the repository, to be dropped or picked. */
export function clip(path: string): Payload {
  const buffer = readFileSync(join(root, path));
  return { name: basename(path), mimeType: "application/octet-stream", buffer };
}

export const good = (name: string) => clip(`tests/files/good/${name}.bvh`);
export const bad = (name: string) => clip(`tests/files/bad/${name}.bvh`);
export const sample = (name: string) => clip(`samples/${name}.bvh`);

/** Returns a clip of two people with the same motion. */
export function twoPeople(clip: Payload): Payload {
  const [hierarchy = "", time = "", rows = ""] = clip.buffer
    .toString()
    .split(/^MOTION\n|(?<=^Frame Time: .*)\n/m);
  const person = (name: string) =>
    hierarchy
      .replace("HIERARCHY", "")
      .replaceAll(/(ROOT|JOINT) /g, `$1 ${name}:`)
      .trim();
  const motion = rows
    .trimEnd()
    .split("\n")
    .map((row) => `${row.trim()} ${row.trim()}`);
  return file(
    "two.people.bvh",
    `HIERARCHY\n${person("A")}\n${person("B")}\nMOTION\n${time}\n${motion.join("\n")}\n`,
  );
}

export interface Sample {
  name: string;
  title: string;
}

/** Returns a file with the given text. */
export const file = (name: string, text: string): Payload => ({
  name,
  mimeType: "application/octet-stream",
  buffer: Buffer.from(text),
});

/** Returns a clip whose motion is repeated. */
export function repeated(clip: Payload, times: number): Payload {
  const [head = "", motion = ""] = clip.buffer.toString().split(/^Frames: .*\n/m);
  const [time = "", ...rows] = motion.trimEnd().split("\n");
  const allRows = Array.from({ length: times }, () => rows).flat();
  return file(clip.name, `${head}Frames: ${allRows.length}\n${time}\n${allRows.join("\n")}\n`);
}

/** The samples in the order of the gallery. */
export const samples: readonly Sample[] = JSON.parse(
  readFileSync(join(root, "samples/index.json"), "utf8"),
);

export interface ValidFile {
  name: string;
  frames: number;
  notices: string[];
}

export interface InvalidFile {
  name: string;
  /** Position of the error, such as `line 5, column 53`, if the reader reports one. */
  location?: string;
  message: string;
}

const rows = readFileSync(join(root, "tests/files/expected.txt"), "utf8").split("\n");

/** Complete valid files with their expected properties. */
export const validFiles: readonly ValidFile[] = rows.flatMap((row) => {
  const match = /^good\/([^/]+)\.bvh: (\d+) frames(?:, (.+))?$/.exec(row);
  if (!match?.[1]) return [];
  const notices = match[3]?.split(", ").map((notice) => notice.replace(/ .*/, "")) ?? [];
  return [{ name: match[1], frames: Number(match[2]), notices }];
});

/** Complete invalid files with their expected errors. */
export const invalidFiles: readonly InvalidFile[] = rows.flatMap((row) => {
  const match = /^bad\/([^/]+)\.bvh:(?:(\d+):(\d+):)? \w+: (.+)$/.exec(row);
  if (!match?.[1] || !match[4]) return [];
  const invalid: InvalidFile = { name: match[1], message: match[4] };
  if (match[2]) invalid.location = `line ${match[2]}, column ${match[3]}`;
  return [invalid];
});

const corpus = process.env.PLANTIGRADE_CORPUS ?? join(root, "../shared/corpus");

/** Returns the path of a recorded clip, or undefined if it is not available. */
export function recorded(path: string): string | undefined {
  const file = join(corpus, path);
  return existsSync(file) ? file : undefined;
}
