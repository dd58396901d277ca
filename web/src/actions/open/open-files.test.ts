import { beforeEach, describe, expect, it, vi } from "vitest";
import { batchRows, tableVisible } from "../../store/batch";
import { ClipSession, openSession } from "../../store/clip-session";
import { openClip } from "../../store/session";
import { toasts } from "../../store/toasts";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { errorReport } = await import("../../store/errors");
const { openFiles } = await import("./open-files");

const clip = (name: string) => new File(["HIERARCHY"], name);
const video = (name: string) => new File(["\0\0\0\u0018ftypmp42"], name);
const drop = (...files: File[]) => openFiles({ files });
const texts = () => toasts.value.map(({ text }) => text);

beforeEach(() => {
  errorReport.value = null;
  toasts.value = [];
  tableVisible.value = false;
  openSession(new ClipSession(null, null, { isPreview: true }));
});

describe("videos that are not shown are reported", () => {
  it("if several clips were dropped", async () => {
    await drop(clip("a.bvh"), video("a.mp4"), clip("b.bvh"), video("b.mp4"));
    expect(batchRows.value).toHaveLength(2);
    expect(texts()).toEqual([expect.stringMatching(/^a\.mp4, b\.mp4 .*Open its clip/)]);
  });

  it("if the table is shown", async () => {
    await drop(clip("walk.bvh"));
    await drop(clip("a.bvh"), clip("b.bvh"));
    await drop(video("a.mp4"));
    expect(texts()).toEqual([expect.stringMatching(/^a\.mp4 .*Open its clip/)]);
  });

  it("if there are several for one clip", async () => {
    await drop(clip("a.bvh"), video("a.mp4"), video("a-side.mp4"));
    expect(openClip.value?.name).toBe("a.bvh");
    expect(texts()).toEqual([expect.stringMatching(/^a-side\.mp4 /)]);
  });
});
