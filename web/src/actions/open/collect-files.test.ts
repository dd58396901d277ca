import { describe, expect, it, vi } from "vitest";
import type { Source } from "../../model/sources/source";

const unpacked: File[] = [];

vi.mock("../../engine", () => ({
  zipWorkers: {
    run: async () => ({ ok: true, files: unpacked.map((file) => ({ file })), errors: [] }),
  },
}));

const { attachLabels, collectFiles } = await import("./collect-files");
const { filesOfTransfer } = await import("./transfer");

const source = (path: string): Source => {
  const at = path.lastIndexOf("/") + 1;
  return { name: path.slice(at), folder: path.slice(0, at), data: new Blob() };
};

/** Returns the paths of the labels of each clip, and the names of those that belong to none. */
function attached(clips: string[], labels: string[]) {
  const { clips: attached, errors } = attachLabels(clips.map(source), labels.map(source));
  return {
    labels: attached.map(({ labels = [] }) =>
      labels.map(({ folder, name }) => `${folder}${name}`).join(),
    ),
    errors: errors.map(({ name, failure }) => `${name}: ${failure.message}`),
  };
}

describe("labels belong to the clip", () => {
  it("of their folder", () => {
    const { labels, errors } = attached(
      ["a/walk.bvh", "b/walk.bvh"],
      ["a/walk.json", "b/walk.json", "b/Walk.segments.json"],
    );
    expect(labels).toEqual(["a/walk.json", "b/walk.json,b/Walk.segments.json"]);
    expect(errors).toEqual([]);
  });

  it("with the longest name that theirs starts with", () => {
    const { labels } = attached(
      ["walk.2.bvh", "walk.bvh"],
      ["walk.2.json", "walk.json", "walk.2.events.csv", "walk.truth.json"],
    );
    expect(labels).toEqual(["walk.2.json,walk.2.events.csv", "walk.json,walk.truth.json"]);
  });

  it("of another folder only if there is one of that name", () => {
    const { labels, errors } = attached(
      ["bvh/walk.bvh", "bvh/run.bvh", "more/run.bvh"],
      ["truth/walk.json", "truth/run.json", "truth/jump.json"],
    );
    expect(labels).toEqual(["truth/walk.json", "", ""]);
    expect(errors).toEqual([
      "run.json: several clips of this drop have a matching file name",
      "jump.json: no clip of this drop has a matching file name",
    ]);
  });
});

it("clips with the same name are told apart by their folders", () => {
  const clips = ["a/walk.bvh", "b/walk.bvh", "b/run.bvh"].map(source);
  const titles = attachLabels(clips, []).clips.map(({ title }) => title);
  expect(titles).toEqual(["a/walk.bvh", "b/walk.bvh", undefined]);
});

it("the folder of a file in an archive starts with the archive, unless that is the only file", async () => {
  const zip = (name: string) => new File(["PK\u0003\u0004"], name);
  const foldersOf = async (...files: File[]) =>
    (await collectFiles({ files }))?.clips.map(({ folder, name }) => `${folder}${name}`);
  unpacked.push(new File(["HIERARCHY"], "deep/walk.bvh"));
  expect(await foldersOf(zip("one.zip"))).toEqual(["deep/walk.bvh"]);
  expect(await foldersOf(zip("one.zip"), zip("two.zip"))).toEqual([
    "one.zip/deep/walk.bvh",
    "two.zip/deep/walk.bvh",
  ]);
});

/** Entries of dropped files and folders, of which a folder lists at most a hundred at a time. */
const entry = (fullPath: string) => ({ fullPath, name: fullPath.replace(/^.*\//, "") });
const fileEntry = (path: string, error?: Error) => ({
  ...entry(path),
  isDirectory: false,
  file: (resolve: (file: File) => void, reject: (error: Error) => void) =>
    error ? reject(error) : resolve(new File(["HIERARCHY"], entry(path).name)),
});
const folderEntry = (path: string, children: readonly object[], error?: Error) => ({
  ...entry(path),
  isDirectory: true,
  createReader: () => {
    const rest = [...children];
    return {
      readEntries: (resolve: (entries: object[]) => void, reject: (error: Error) => void) =>
        rest.length || !error ? resolve(rest.splice(0, 100)) : reject(error),
    };
  },
});
const transferOf = (...entries: object[]) =>
  ({
    items: entries.map((entry) => ({ webkitGetAsEntry: () => entry })),
    files: [],
  }) as unknown as DataTransfer;
const collectedFrom = async (...entries: object[]) => {
  const collected = await collectFiles(await filesOfTransfer(transferOf(...entries)));
  return {
    clips: collected?.clips.map(({ folder, name }) => `${folder}${name}`) ?? [],
    labels: collected?.labels.map(({ folder, name }) => `${folder}${name}`) ?? [],
    errors: collected?.errors.map(({ name, failure }) => `${name}: ${failure.message}`) ?? [],
  };
};

describe("a dropped folder", () => {
  it("is read with its subfolders, also if they have more entries than are listed at a time", async () => {
    const clips = Array.from({ length: 250 }, (_, i) => fileEntry(`/take/deep/${i}.bvh`));
    const { clips: found, errors } = await collectedFrom(
      folderEntry("/take", [
        fileEntry("/take/z.bvh"),
        fileEntry("/take/notes.txt"),
        fileEntry("/take/._z.bvh"),
        folderEntry("/take/deep", clips.toReversed()),
      ]),
    );
    expect(found).toEqual([...clips.map((_, i) => `take/deep/${i}.bvh`), "take/z.bvh"]);
    expect(errors).toEqual([]);
  });

  it("is opened without the files and folders that cannot be read, which are reported", async () => {
    const denied = new DOMException("permission denied", "NotReadableError");
    const { clips, errors } = await collectedFrom(
      folderEntry("/take", [
        folderEntry("/take/locked", [], denied),
        folderEntry("/take/partly", [fileEntry("/take/partly/walk.bvh")], denied),
        fileEntry("/take/gone.bvh", denied),
        fileEntry("/take/run.bvh"),
      ]),
      fileEntry("/also-gone.bvh", denied),
    );
    expect(clips).toEqual(["take/partly/walk.bvh", "take/run.bvh"]);
    expect(errors).toEqual([
      "take/locked: the folder cannot be read (permission denied)",
      "take/partly: the folder cannot be read (permission denied)",
      "take/gone.bvh: the file cannot be read (permission denied)",
      "also-gone.bvh: the file cannot be read (permission denied)",
    ]);
  });

  it("has at most 5000 files", async () => {
    const clips = Array.from({ length: 5001 }, (_, i) => fileEntry(`/take/${i}.bvh`));
    const { clips: found, errors } = await collectedFrom(folderEntry("/take", clips));
    expect(found).toHaveLength(5000);
    expect(errors).toEqual([expect.stringContaining("more than 5000 files")]);
  });

  it("is reported if it has no file to open", async () => {
    const { errors } = await collectedFrom(folderEntry("/take", [fileEntry("/take/notes.txt")]));
    expect(errors).toEqual(["take: the folder contains no BVH file"]);
  });

  it("is read with the segments that were saved for its clips", async () => {
    const names = [
      "walk.bvh",
      "walk.segments.csv",
      "walk.audacity.txt",
      "walk.elan.txt",
      "notes.txt",
    ];
    const files = names.map((name) => fileEntry(`/take/${name}`));
    const { clips, labels } = await collectedFrom(folderEntry("/take", files));
    expect([...clips, ...labels]).toHaveLength(4);
  });
});

it("a file that cannot be read is opened as a clip, whose reader reports it", async () => {
  const gone = new File(["HIERARCHY"], "gone.bvh");
  gone.slice = () => {
    throw new DOMException("it is gone", "NotReadableError");
  };
  const collected = await collectFiles({ files: [gone, new File(["HIERARCHY"], "walk.bvh")] });
  expect(collected?.clips.map(({ name }) => name)).toEqual(["gone.bvh", "walk.bvh"]);
});
