import { beforeEach, describe, expect, it, vi } from "vitest";
import * as state from "./state";

vi.mock("../worker", () => import("../lib/testing/engine"));

const { compareWith, dropComparison, stepDisagreement } = await import("./compare");
const { openFiles } = await import("./open");

const clip = () => new File(["HIERARCHY"], "walk.bvh");
const labels = (frames: number) => {
  const foot = new Array(frames).fill(1);
  return new File([JSON.stringify({ left: foot, right: foot })], "truth.json");
};

beforeEach(async () => {
  await openFiles({ files: [clip()] });
  state.tab.value = "detect";
});

describe("comparing", () => {
  it("shows labels dropped beside a clip, which opens first", async () => {
    await openFiles({ files: [labels(720), clip()] });
    expect(state.openClip.value?.name).toBe("walk.bvh");
    expect(state.other.value?.name).toBe("truth.json");
    expect(state.score.value?.part).toBe("toe");
    expect(state.tab.value).toBe("score");
  });

  it("says what is wrong with labels and keeps those before", async () => {
    await compareWith("truth.json", labels(720));
    await compareWith("short.json", labels(7));
    expect(state.failure.value?.failure.message).toContain("7 frames");
    expect(state.other.value?.name).toBe("truth.json");
  });

  it("needs a clip", async () => {
    state.hero.value = true;
    await compareWith("truth.json", labels(720));
    expect(state.failure.value?.failure.hint).toContain("Open the clip first");
  });

  it("steps from difference to difference, round and round", async () => {
    await compareWith("truth.json", labels(720));
    const at = (direction: 1 | -1) => {
      stepDisagreement(direction);
      return state.frame.value;
    };
    expect([at(1), at(1), at(1), at(-1)]).toEqual([10, 90, 10, 90]);
  });

  it("ends when the labels are removed or another clip opens", async () => {
    await compareWith("truth.json", labels(720));
    dropComparison();
    expect(state.score.value).toBeUndefined();
    expect(state.tab.value).toBe("labels");
    await compareWith("truth.json", labels(720));
    await openFiles({ files: [clip()] });
    expect(state.other.value).toBeNull();
    expect(state.scores.value).toEqual([]);
  });
});
