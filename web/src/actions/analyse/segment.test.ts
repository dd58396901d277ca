import { beforeEach, expect, it, vi } from "vitest";
import { frame, loop, loopedRange, loopedSegment } from "../../store/playback";
import {
  cutScores,
  cuts,
  detection,
  namedSegments,
  openClip,
  reference,
  referenceSegments,
  renamedSegment,
  segmentFailure,
} from "../../store/session";
import { segmentOptions } from "../../store/settings";
import { activeTab, sheetOpen } from "../../store/view";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { jobs } = await import("../../store/jobs");
const { phase } = await import("../../store/phase");
const { compareWith, removeReferenceSegments } = await import("./compare");
const { openFiles } = await import("../open/open-files");
const { loopSegment, stepCut } = await import("../view/playback");
const { editSegmentName, setSegmentName, setSegmentOptions } = await import("./segment");

const clip = (name = "walk.bvh") => new File(["HIERARCHY"], name);
const first = () => {
  const [segment] = namedSegments.value;
  if (!segment) throw new Error("no segments");
  return segment;
};
const starts = () => namedSegments.value.map(({ start }) => start);

beforeEach(async () => {
  segmentOptions.value = { method: "auto" };
  await openFiles({ files: [clip()] });
});

it("runs when a clip is opened, also without feet", async () => {
  expect(phase.value).toBe("ready");
  expect(starts()).toEqual([0, 240, 480]);
  expect(cuts.value).toEqual([240, 480]);
  await openFiles({ files: [clip("crab.bvh")] });
  expect(detection.value).toBeNull();
  expect(starts()).toEqual([0, 240, 480]);
});

it("runs again when a setting changes, and preserves names of the same actions", async () => {
  setSegmentName(first(), "walk");
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

it("continues to loop the segment of the same action, otherwise the clip", async () => {
  loopSegment(first());
  setSegmentOptions({ method: "longer" });
  await vi.waitFor(() => expect(loopedRange.value?.end).toBe(360));
  expect(loopedSegment.value?.number).toBe(1);
  setSegmentOptions({ method: "longest-of-all" });
  await vi.waitFor(() => expect(loop.value).toBe("clip"));
  expect(loopedRange.value).toBeNull();
});

it("leaves segments and settings unchanged when it is stopped", async () => {
  setSegmentOptions({ method: "mvu" });
  await vi.waitFor(() => expect(jobs.value[0]?.fraction).toBe(0.5));
  expect(phase.value).toBe("ready");
  jobs.value[0]?.stop();
  expect(jobs.value).toEqual([]);
  expect(segmentOptions.value).toEqual({ method: "auto" });
  expect(starts()).toEqual([0, 240, 480]);
});

it("is stopped by another clip, and reports that it was stopped", async () => {
  segmentOptions.value = { method: "mvu" };
  const pending = openFiles({ files: [clip()] });
  await vi.waitFor(() => expect(jobs.value).toHaveLength(1));
  expect(phase.value).toBe("loading");
  jobs.value[0]?.stop();
  await pending;
  expect(phase.value).toBe("ready");
  expect(segmentFailure.value?.message).toContain("cancelled");
  const again = openFiles({ files: [clip()] });
  await vi.waitFor(() => expect(jobs.value).toHaveLength(1));
  segmentOptions.value = { method: "auto" };
  await Promise.all([again, openFiles({ files: [clip("other.bvh")] })]);
  expect(openClip.value?.name).toBe("other.bvh");
  expect(starts()).toEqual([0, 240, 480]);
});

it("steps from cut to cut and to the ends of the clip", () => {
  const at = (direction: 1 | -1) => {
    stepCut(direction);
    return frame.value;
  };
  expect([at(1), at(1), at(1), at(-1), at(-1), at(-1)]).toEqual([240, 480, 719, 480, 240, 0]);
});

it("compares with reference segments", async () => {
  const segments = [{ start: 0, end: 720, kind: "action", label: "walk" }];
  const file = new File([JSON.stringify({ segments })], "truth.json");
  await openFiles({ files: [file, clip()] });
  expect(referenceSegments.value?.name).toBe("truth.json");
  expect(reference.value).toBeNull();
  expect(activeTab.value).toBe("segment");
  expect(cutScores.value[0]?.recall).toBe(0.5);
  removeReferenceSegments();
  expect(cutScores.value).toEqual([]);
  await compareWith("truth.json", file);
  await openFiles({ files: [clip()] });
  expect(referenceSegments.value).toBeNull();
});

it("shows the name field of a segment", () => {
  editSegmentName(first());
  expect(activeTab.value).toBe("segment");
  expect(sheetOpen.value).toBe(true);
  expect(renamedSegment.value?.number).toBe(1);
});
