import { beforeEach, expect, it } from "vitest";
import { walker, walkerTrack } from "../lib/testing/walker";
import { changeSpeed, cycleLoop, seek, seekPlant, step, stepEdge } from "./playback";
import * as state from "./state";

const clip = walker("walk.bvh");
const toe = {
  left: walkerTrack(clip, 0, 0.1, 0.6, 0, 17),
  right: walkerTrack(clip, 0.5, 0.1, 0.6, 0, 22),
};

beforeEach(() => {
  state.hero.value = false;
  state.clip.value = clip;
  state.detection.value = {
    options: { method: "paper", r: 0.001, w: 1 },
    parts: { toe },
    floor: 0,
    notices: [],
  };
  state.timeView.value = { start: 0, end: clip.frames };
  state.loop.value = "clip";
  seek(0);
});

it("stays inside the clip", () => {
  step(-1);
  expect(state.frame.value).toBe(0);
  seek(1e6);
  expect(state.frame.value).toBe(clip.frames - 1);
});

it("goes from plant edge to plant edge and back", () => {
  const edges = state.edges.value;
  stepEdge(1);
  stepEdge(1);
  const second = edges.filter((edge) => edge > 0)[1];
  expect(state.frame.value).toBe(second);
  stepEdge(-1);
  expect(state.frame.value).toBe(edges.filter((edge) => edge > 0)[0]);
});

it("turns the timeline's page to where it goes", () => {
  state.timeView.value = { start: 0, end: 100 };
  seek(500);
  expect(state.timeView.value.start).toBeGreaterThan(400);
});

it("loops the plant under the playhead, then nothing, then the clip", () => {
  const plant = state.plants.value[3];
  if (!plant) throw new Error("no fourth plant");
  seekPlant(plant);
  expect(state.announcement.value).toContain("Plant 4");
  cycleLoop();
  expect(state.loop.value).toBe("plant");
  cycleLoop();
  expect(state.loop.value).toBe("off");
  cycleLoop();
  expect(state.loop.value).toBe("clip");
});

it("changes speed in steps and stops at the ends", () => {
  state.speed.value = 1;
  changeSpeed(1);
  expect(state.speed.value).toBe(1.5);
  for (let i = 0; i < 20; i++) changeSpeed(-1);
  expect(state.speed.value).toBe(0.1);
});
