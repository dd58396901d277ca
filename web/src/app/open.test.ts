import { beforeEach, describe, expect, it, vi } from "vitest";
import * as state from "./state";

vi.mock("../worker", () => import("../lib/testing/engine"));

const { cancelOpening, openFiles, openSample, openSource, sizeLimit } = await import("./open");
const { setOptions } = await import("./detect");

const file = (name: string) => new File(["HIERARCHY"], name);

beforeEach(() => {
  state.failure.value = null;
  state.task.value = null;
});

describe("opening", () => {
  it("shows the clip and its plants", async () => {
    await openFiles([file("walk.bvh")]);
    expect(state.phase.value).toBe("ready");
    expect(state.openClip.value?.name).toBe("walk.bvh");
    expect(state.plants.value.length).toBeGreaterThan(10);
    expect(state.timeView.value).toEqual({ start: 0, end: 720 });
  });

  it("says what is wrong and keeps the clip before", async () => {
    await openFiles([file("walk.bvh")]);
    await openFiles([file("bad.bvh")]);
    expect(state.phase.value).toBe("error");
    expect(state.failure.value?.failure.line).toBe(466);
    expect(state.openClip.value?.name).toBe("walk.bvh");
  });

  it("takes the first of several files that can be read and lists the others", async () => {
    await openFiles([file("bad.bvh"), file("walk.bvh"), file("second.bvh")]);
    expect(state.openClip.value?.name).toBe("walk.bvh");
    expect(state.failure.value).toBeNull();
    expect(state.dropped.value.map((source) => source.name)).toEqual([
      "bad.bvh",
      "walk.bvh",
      "second.bvh",
    ]);
  });

  it("tells of every file it refused on the way", async () => {
    await openFiles([file("bad.bvh"), file("walk.bvh")]);
    expect(state.phase.value).toBe("ready");
    expect(state.refused.value.map(({ name }) => name)).toEqual(["bad.bvh"]);
    expect(state.refusedShown.value).toBe(true);
    await openFiles([file("bad.bvh"), file("bad too.bvh")]);
    expect(state.refused.value.map(({ name }) => name)).toEqual(["bad.bvh", "bad too.bvh"]);
    expect(state.openClip.value?.name).toBe("walk.bvh");
  });

  it("refuses what is too large before reading it", async () => {
    const data = new Blob();
    Object.defineProperty(data, "size", { value: sizeLimit + 1 });
    expect(await openSource({ name: "huge.bvh", data })).toBe(false);
    expect(state.failure.value?.failure.message).toContain("limit");
  });

  it("can be cancelled", async () => {
    await openFiles([file("walk.bvh")]);
    const opening = openFiles([file("slow.bvh")]);
    expect(state.phase.value).toBe("loading");
    cancelOpening();
    await opening;
    expect(state.phase.value).toBe("ready");
    expect(state.openClip.value?.name).toBe("walk.bvh");
  });

  it("knows which samples there are", async () => {
    expect(await openSample("nobody")).toBe(false);
    expect(state.failure.value?.failure.message).toContain("nobody");
  });
});

describe("a clip without labels", () => {
  it("still shows where no feet are found", async () => {
    await openFiles([file("crab.bvh")]);
    expect(state.openClip.value?.name).toBe("crab.bvh");
    expect(state.detection.value).toBeNull();
    expect(state.detectFailure.value?.message).toContain("no feet");
  });
});

it("labels anew when a setting changes", async () => {
  await openFiles([file("walk.bvh")]);
  setOptions({ method: "paper" });
  await vi.waitFor(() => expect(state.detection.value?.options.method).toBe("paper"));
  expect(state.detection.value?.parts.heel).toBeUndefined();
  setOptions({ method: "robust" });
});
