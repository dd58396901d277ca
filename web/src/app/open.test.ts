import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Row } from "./batch";
import { sizeLimit } from "./limits";
import * as state from "./state";

vi.mock("../worker", () => import("../lib/testing/engine"));

const { cancelOpening, openFiles, openSample, openSource } = await import("./open");
const { openRow, rows, tableShown } = await import("./batch");
const { detecting, setOptions } = await import("./detect");

const file = (name: string) => new File(["HIERARCHY"], name);

beforeEach(() => {
  state.failure.value = null;
  state.task.value = null;
});

describe("opening", () => {
  it("shows the clip and its plants", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    expect(state.phase.value).toBe("ready");
    expect(state.openClip.value?.name).toBe("walk.bvh");
    expect(state.plants.value.length).toBeGreaterThan(10);
    expect(state.timeView.value).toEqual({ start: 0, end: 720 });
  });

  it("says what is wrong and keeps the clip before", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    await openFiles({ files: [file("bad.bvh")] });
    expect(state.phase.value).toBe("error");
    expect(state.failure.value?.failure.line).toBe(466);
    expect(state.openClip.value?.name).toBe("walk.bvh");
  });

  it("lays several clips on a table", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    await openFiles({ files: [file("bad.bvh"), file("walk.bvh"), file("second.bvh")] });
    expect(tableShown.value).toBe(true);
    expect(rows.value.map(({ source }) => source.name)).toEqual([
      "bad.bvh",
      "walk.bvh",
      "second.bvh",
    ]);
    expect(rows.value.map(({ status }) => status)).toEqual(["failed", "done", "done"]);
    expect(state.openClip.value?.name).toBe("walk.bvh");
    await openRow(rows.value[2] as Row);
    expect(tableShown.value).toBe(false);
    expect(state.openClip.value?.name).toBe("second.bvh");
  });

  it("refuses what is too large before reading it", async () => {
    const data = new Blob();
    Object.defineProperty(data, "size", { value: sizeLimit + 1 });
    expect(await openSource({ name: "huge.bvh", data })).toBe(false);
    expect(state.failure.value?.failure.message).toContain("limit");
  });

  it("can be cancelled", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    const opening = openFiles({ files: [file("slow.bvh")] });
    await vi.waitFor(() => expect(state.phase.value).toBe("loading"));
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
    await openFiles({ files: [file("crab.bvh")] });
    expect(state.openClip.value?.name).toBe("crab.bvh");
    expect(state.detection.value).toBeNull();
    expect(state.detectFailure.value?.message).toContain("no feet");
  });
});

it("labels anew when a setting changes", async () => {
  await openFiles({ files: [file("walk.bvh")] });
  setOptions({ method: "paper" });
  await vi.waitFor(() => expect(state.detection.value?.options.method).toBe("paper"));
  expect(state.detection.value?.parts.heel).toBeUndefined();
  setOptions({ method: "robust" });
});

it("can be stopped while it labels, and the labels and settings before stay", async () => {
  await openFiles({ files: [file("walk.bvh")] });
  setOptions({ method: "njw" });
  expect(detecting.value).toBe(true);
  await vi.waitFor(() => expect(state.work.value[0]?.what).toBe("Finding plants in"));
  expect(state.phase.value).toBe("ready");
  state.work.value[0]?.stop();
  expect(state.options.value.method).toBe("robust");
  await vi.waitFor(() => expect(detecting.value).toBe(false));
  expect(state.detection.value?.options.method).toBe("robust");
  expect(state.work.value).toEqual([]);
});

it("leaves a clip that is opened without labels where a person stops it, and says so", async () => {
  state.options.value = { ...state.options.value, method: "njw" };
  const opening = openFiles({ files: [file("walk.bvh")] });
  await vi.waitFor(() => expect(state.task.value?.stage).toBe("detect"));
  cancelOpening();
  await opening;
  expect(state.phase.value).toBe("ready");
  expect(state.openClip.value?.name).toBe("walk.bvh");
  expect(state.detectFailure.value?.message).toContain("cancelled");
  setOptions({ method: "robust" });
  await vi.waitFor(() => expect(state.detection.value?.options.method).toBe("robust"));
});

it("does not let a setting wait for what takes long, nor end what is quick", async () => {
  await openFiles({ files: [file("walk.bvh")] });
  vi.useFakeTimers({ toFake: ["performance"] });
  setOptions({ method: "njw" });
  setOptions({ method: "paper" });
  await Promise.resolve();
  expect(state.work.value).toHaveLength(1);
  vi.advanceTimersByTime(3000);
  setOptions({ method: "robust", r: 0.002 });
  vi.useRealTimers();
  await vi.waitFor(() => expect(state.detection.value?.options.r).toBe(0.002));
  setOptions({ r: 0.001 });
});
