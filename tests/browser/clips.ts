/** The clips of the tests: the samples, the files good and bad, and recorded motion where there is any. */

import { existsSync, readFileSync } from "node:fs";
import { basename, join } from "node:path";

export const root = join(import.meta.dirname, "../..");

export interface Payload {
  name: string;
  mimeType: string;
  buffer: Buffer;
}

/** A file of the project as a person's own, under the name it has. */
export function clip(path: string): Payload {
  const buffer = readFileSync(join(root, path));
  return { name: basename(path), mimeType: "application/octet-stream", buffer };
}

export const good = (name: string) => clip(`tests/files/good/${name}.bvh`);
export const bad = (name: string) => clip(`tests/files/bad/${name}.bvh`);
export const sample = (name: string) => clip(`samples/${name}.bvh`);

export interface Sample {
  name: string;
  title: string;
}

/** A file of a person's own. */
export const file = (name: string, text: string): Payload => ({
  name,
  mimeType: "application/octet-stream",
  buffer: Buffer.from(text),
});

/** The same clip with its motion so many times over. */
export function repeated(clip: Payload, times: number): Payload {
  const [head = "", motion = ""] = clip.buffer.toString().split(/^Frames: .*\n/m);
  const [time = "", ...rows] = motion.trimEnd().split("\n");
  const all = Array.from({ length: times }, () => rows).flat();
  return file(clip.name, `${head}Frames: ${all.length}\n${time}\n${all.join("\n")}\n`);
}

/** The samples in the order of the gallery. */
export const samples: readonly Sample[] = JSON.parse(
  readFileSync(join(root, "samples/index.json"), "utf8"),
);

export interface Expected {
  name: string;
  frames: number;
  notices: string[];
}

export interface Refused {
  name: string;
  /** `line 5, column 53`, where the reader knows it. */
  place?: string;
  message: string;
}

const rows = readFileSync(join(root, "tests/files/expected.txt"), "utf8").split("\n");

/** Every file that opens, with what must be said of it. */
export const opens: readonly Expected[] = rows.flatMap((row) => {
  const found = /^good\/(.+)\.bvh: (\d+) frames(?:, (.+))?$/.exec(row);
  if (!found?.[1]) return [];
  return [{ name: found[1], frames: Number(found[2]), notices: found[3]?.split(", ") ?? [] }];
});

/** Every file that is refused, with why. */
export const refused: readonly Refused[] = rows.flatMap((row) => {
  const found = /^bad\/(.+)\.bvh:(?:(\d+):(\d+):)? error: (.+)$/.exec(row);
  if (!found?.[1] || !found[4]) return [];
  const refusal: Refused = { name: found[1], message: found[4] };
  if (found[2]) refusal.place = `line ${found[2]}, column ${found[3]}`;
  return [refusal];
});

const corpus = process.env.PLANTIGRADE_CORPUS ?? join(root, "../shared/corpus");

/** A recorded clip; undefined where this machine has none. */
export function recorded(path: string): string | undefined {
  const file = join(corpus, path);
  return existsSync(file) ? file : undefined;
}
