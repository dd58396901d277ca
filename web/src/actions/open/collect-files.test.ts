import { describe, expect, it, vi } from "vitest";
import type { Source } from "../../model/sources/source";

const unpacked: File[] = [];

vi.mock("../../engine", () => ({
  zipWorkers: {
    run: async () => ({ ok: true, files: unpacked.map((file) => ({ file })), errors: [] }),
  },
}));

const { attachLabels, collectFiles } = await import("./collect-files");

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
