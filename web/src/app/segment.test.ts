import { beforeEach, expect, it, vi } from "vitest";
import * as state from "./state";

vi.mock("../worker", () => import("../lib/testing/engine"));

const { compareWith, dropOtherSegments } = await import("./compare");
const { openFiles } = await import("./open");
const { loopSegment, stepCut } = await import("./playback");
const { askForName, rename, setSegmentOptions } = await import("./segment");

const clip = (name = "walk.bvh") => new File(["HIERARCHY"], name);
const first = () => {
  const [action] = state.actions.value;
  if (!action) throw new Error("no segments");
  return action;
};
const starts = () => state.actions.value.map(({ start }) => start);

beforeEach(async () => {
  state.segmentOptions.value = { method: "auto" };
  await openFiles({ files: [clip()] });
});

it("comes with the clip, also where there are no feet", async () => {
  expect(state.phase.value).toBe("ready");
  expect(starts()).toEqual([0, 240, 480]);
  expect(state.cuts.value).toEqual([240, 480]);
  await openFiles({ files: [clip("crab.bvh")] });
  expect(state.detection.value).toBeNull();
  expect(starts()).toEqual([0, 240, 480]);
});

it("cuts anew when a setting changes, and keeps names where they still hold", async () => {
  rename(first(), "walk");
  setSegmentOptions({ method: "longer" });
  await vi.waitFor(() => expect(starts()).toEqual([0, 360]));
  expect(first().name).toBe("walk");
  setSegmentOptions({ method: "longest-one" });
  await vi.waitFor(() => expect(starts()).toEqual([0, 660]));
  expect(first().name).toBe("");
  setSegmentOptions({ method: "auto" });
  await vi.waitFor(() => expect(first().name).toBe("walk"));
  await openFiles({ files: [clip()] });
  expect(first().name).toBe("");
});

it("goes on looping a segment that is the same action, and the clip otherwise", async () => {
  loopSegment(first());
  setSegmentOptions({ method: "longer" });
  await vi.waitFor(() => expect(state.looped.value?.end).toBe(360));
  expect(state.chosen.value?.number).toBe(1);
  setSegmentOptions({ method: "longest-of-all" });
  await vi.waitFor(() => expect(state.loop.value).toBe("clip"));
  expect(state.looped.value).toBeNull();
});

it("can be stopped, and what was there stays", async () => {
  setSegmentOptions({ method: "mvu" });
  await vi.waitFor(() => expect(state.work.value[0]?.share).toBe(0.5));
  expect(state.phase.value).toBe("ready");
  state.work.value[0]?.stop();
  expect(state.work.value).toEqual([]);
  expect(state.segmentOptions.value).toEqual({ method: "auto" });
  expect(starts()).toEqual([0, 240, 480]);
});

it("makes way for a clip that is opened, and says so where nothing was found before", async () => {
  state.segmentOptions.value = { method: "mvu" };
  const opening = openFiles({ files: [clip()] });
  await vi.waitFor(() => expect(state.work.value).toHaveLength(1));
  expect(state.phase.value).toBe("loading");
  state.work.value[0]?.stop();
  await opening;
  expect(state.phase.value).toBe("ready");
  expect(state.segmentFailure.value?.message).toContain("cancelled");
  const again = openFiles({ files: [clip()] });
  await vi.waitFor(() => expect(state.work.value).toHaveLength(1));
  state.segmentOptions.value = { method: "auto" };
  await Promise.all([again, openFiles({ files: [clip("other.bvh")] })]);
  expect(state.openClip.value?.name).toBe("other.bvh");
  expect(starts()).toEqual([0, 240, 480]);
});

it("steps from cut to cut and to the ends", () => {
  const at = (direction: 1 | -1) => {
    stepCut(direction);
    return state.frame.value;
  };
  expect([at(1), at(1), at(1), at(-1), at(-1), at(-1)]).toEqual([240, 480, 719, 480, 240, 0]);
});

it("shows segments of someone else beside ours", async () => {
  const segments = [{ start: 0, end: 720, kind: "action", label: "walk" }];
  const file = new File([JSON.stringify({ segments })], "truth.json");
  await openFiles({ files: [file, clip()] });
  expect(state.otherSegments.value?.name).toBe("truth.json");
  expect(state.other.value).toBeNull();
  expect(state.tab.value).toBe("segment");
  expect(state.cutScores.value[0]?.recall).toBe(0.5);
  dropOtherSegments();
  expect(state.cutScores.value).toEqual([]);
  await compareWith("truth.json", file);
  await openFiles({ files: [clip()] });
  expect(state.otherSegments.value).toBeNull();
});

it("takes a person to the name that is asked for", () => {
  askForName(first());
  expect(state.tab.value).toBe("segment");
  expect(state.sheetOpen.value).toBe(true);
  expect(state.renaming.value?.number).toBe(1);
});
