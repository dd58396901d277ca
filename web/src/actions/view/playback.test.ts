import { beforeEach, expect, it, vi } from "vitest";
import { plantEdges } from "../../model/plants/plants";
import { ClipSession, openSession } from "../../store/clip-session";
import { frame, loop, speed, timeView } from "../../store/playback";
import { detection, plants, selected } from "../../store/session";
import { announcement } from "../../store/view";
import { createWalkingClip, createWalkingTrack } from "../../testing/walking-clip";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { changeSpeed, cycleLoop, seek, seekPlant, stepFrame } = await import("./playback");
const { select, stepEdge } = await import("../edit/edit");

const clip = createWalkingClip("walk.bvh");
const toe = {
  left: createWalkingTrack(clip, 0, 0.1, 0.6, 0, 17),
  right: createWalkingTrack(clip, 0.5, 0.1, 0.6, 0, 22),
};

beforeEach(() => {
  openSession(new ClipSession(clip, { name: "walk.bvh", data: new Blob() }));
  detection.value = {
    options: { method: "paper", r: 0.001, w: 1 },
    parts: { toe },
    floor: 0,
    ground: { normal: [0, 1, 0], origin: [0, 0, 0], tilt: 0, levels: [0] },
    notices: [],
  };
});

it("stays inside the clip", () => {
  stepFrame(-1);
  expect(frame.value).toBe(0);
  seek(1e6);
  expect(frame.value).toBe(clip.frames - 1);
});

it("steps to plant edges in both directions", () => {
  stepEdge(1);
  stepEdge(1);
  const [first, second] = plantEdges(plants.value).filter((edge) => edge > 0);
  expect(frame.value).toBe(second);
  stepEdge(-1);
  expect(frame.value).toBe(first);
  expect(selected.value).toBeNull();
});

it("moves a selection to the plant of the edge that is reached", () => {
  const part = "toe";
  const track = (...intervals: number[]) => ({
    ...toe.left,
    intervals: Uint32Array.from(intervals),
  });
  const found = {
    ...detection.value,
    parts: { toe: { left: track(10, 20, 40, 51), right: track(15, 51, 60, 70) } },
  };
  detection.value = found as NonNullable<typeof detection.value>;
  select({ side: "left", part, start: 10, end: 20 });
  seek(10);
  const visited = (direction: 1 | -1, count: number) =>
    Array.from({ length: count }, () => {
      stepEdge(direction);
      return [frame.value, selected.value?.side, selected.value?.start];
    });
  expect(visited(1, 6)).toEqual([
    [15, "right", 15],
    [19, "left", 10],
    [40, "left", 40],
    // Both feet have an edge here.
    [50, "left", 40],
    [60, "right", 60],
    [69, "right", 60],
  ]);
  expect(visited(-1, 2)).toEqual([
    [60, "right", 60],
    [50, "right", 15],
  ]);
});

it("scrolls the timeline to the playhead", () => {
  timeView.value = { start: 0, end: 100 };
  seek(500);
  expect(timeView.value.start).toBeGreaterThan(400);
});

it("loops the plant under the playhead, then nothing, then the clip", () => {
  const plant = plants.value[3];
  if (!plant) throw new Error("no fourth plant");
  seekPlant(plant);
  expect(announcement.value).toContain("Plant 4");
  cycleLoop();
  expect(loop.value).toBe("plant");
  cycleLoop();
  expect(loop.value).toBe("off");
  cycleLoop();
  expect(loop.value).toBe("clip");
});

it("changes the speed in steps and stops at the ends", () => {
  speed.value = 1;
  changeSpeed(1);
  expect(speed.value).toBe(1.5);
  for (let i = 0; i < 20; i++) changeSpeed(-1);
  expect(speed.value).toBe(0.1);
});
