import { beforeEach, describe, expect, it, vi } from "vitest";
import { ClipSession, openSession } from "../../store/clip-session";
import { frame } from "../../store/playback";
import { openClip, reference, score, scores } from "../../store/session";
import { activeTab } from "../../store/view";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { errorReport } = await import("../../store/errors");
const { compareWith, compareWithAll, removeReference, stepDisagreement } = await import(
  "./compare"
);
const { openFiles } = await import("../open/open-files");

const clip = () => new File(["HIERARCHY"], "walk.bvh");
const labels = (frames: number) => {
  const foot = new Array(frames).fill(1);
  return new File([JSON.stringify({ left: foot, right: foot })], "truth.json");
};

beforeEach(async () => {
  await openFiles({ files: [clip()] });
  activeTab.value = "detect";
});

describe("comparing", () => {
  it("opens the clip before the labels that were dropped with it", async () => {
    await openFiles({ files: [labels(720), clip()] });
    expect(openClip.value?.name).toBe("walk.bvh");
    expect(reference.value?.name).toBe("truth.json");
    expect(score.value?.part).toBe("toe");
    expect(activeTab.value).toBe("score");
  });

  it("reports invalid labels and leaves the previous ones unchanged", async () => {
    await compareWith("truth.json", labels(720));
    await compareWith("short.json", labels(7));
    expect(errorReport.value?.failure.message).toContain("7 frames");
    expect(reference.value?.name).toBe("truth.json");
  });

  it("does not compare another clip with files that were dropped with the one before", async () => {
    const files = ["a.json", "b.json"].map((name) => ({ name, data: labels(720) }));
    const compared = compareWithAll(files);
    openSession(new ClipSession(openClip.value, null, { isPreview: false }));
    await compared;
    expect(reference.value).toBeNull();
  });

  it("requires an open clip", async () => {
    openSession(new ClipSession(null, null, { isPreview: true }));
    await compareWith("truth.json", labels(720));
    expect(errorReport.value?.failure.hint).toContain("Open the clip first");
  });

  it("steps through the disagreements and wraps around", async () => {
    await compareWith("truth.json", labels(720));
    const at = (direction: 1 | -1) => {
      stepDisagreement(direction);
      return frame.value;
    };
    expect([at(1), at(1), at(1), at(-1)]).toEqual([10, 90, 10, 90]);
  });

  it("ends when the reference is removed or another clip is opened", async () => {
    await compareWith("truth.json", labels(720));
    removeReference();
    expect(score.value).toBeUndefined();
    expect(activeTab.value).toBe("labels");
    await compareWith("truth.json", labels(720));
    await openFiles({ files: [clip()] });
    expect(reference.value).toBeNull();
    expect(scores.value).toEqual([]);
  });
});
