import { beforeEach, expect, it, vi } from "vitest";
import { ClipSession, openSession } from "../store/clip-session";
import { frame, loop, speed, timeView } from "../store/playback";
import { detection, edges, plants } from "../store/session";
import { announcement } from "../store/view";
import { createWalkingClip, createWalkingTrack } from "../testing/walking-clip";

vi.mock("../engine", () => import("../testing/fake-engine"));

const { changeSpeed, cycleLoop, seek, seekPlant, stepEdge, stepFrame } = await import("./playback");

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
  const [first, second] = edges.value.filter((edge) => edge > 0);
  expect(frame.value).toBe(second);
  stepEdge(-1);
  expect(frame.value).toBe(first);
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
