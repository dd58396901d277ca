import { beforeEach, describe, expect, it, vi } from "vitest";
import { batchRows, labelsForTable, tableVisible } from "../../store/batch";
import { ClipSession, openSession } from "../../store/clip-session";
import { openClip, reference } from "../../store/session";
import { toasts } from "../../store/toasts";

/** The agreement is higher the more bytes the last file of labels has; empty ones cannot be read. */
const summarize = async (
  _file: Blob,
  _name: string,
  _request: object,
  labels: Blob[],
): Promise<unknown> => {
  const agreement = labels.findLast(({ size }) => size > 0)?.size;
  return { ok: true, summary: { notices: 0, ...(agreement && { agreement }) }, files: [] };
};

vi.mock("../../engine", async () => ({
  ...(await import("../../testing/fake-engine")),
  batchWorkers: {
    run: (job: (calls: unknown) => unknown) => job({ summarize, commonActions: async () => [] }),
  },
}));

const { errorReport } = await import("../../store/errors");
const { openRow } = await import("../analyse/batch");
const { addLabels } = await import("../analyse/row-labels");
const { openFiles } = await import("./open-files");

const clip = (name: string) => new File(["HIERARCHY"], name);
const labels = (name: string, frames: number) => {
  const foot = Array(frames).fill(1);
  return new File([JSON.stringify({ left: foot, right: foot })], name);
};
const video = (name: string) => new File(["\0\0\0\u0018ftypmp42"], name);
const agreements = () => batchRows.value.map(({ summary }) => summary?.agreement);
/** Drops files, as on a page that shows the table if it is visible. */
const drop = async (...files: File[]) => {
  await openFiles({ files });
  await addLabels(labelsForTable.value);
  labelsForTable.value = [];
};
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

describe("labels that are dropped on the table", () => {
  beforeEach(async () => {
    await drop(clip("walk.bvh"));
    await drop(clip("walk.bvh"), clip("run.bvh"), clip("jump.bvh"));
  });

  it("are compared with their clips, not with the hidden one", async () => {
    const dropped = [labels("run.json", 7), labels("jump.json", 9)];
    await drop(...dropped);
    expect(errorReport.value).toBeNull();
    expect(reference.value).toBeNull();
    expect(agreements()).toEqual([undefined, ...dropped.map(({ size }) => size)]);
    expect(texts()).toEqual(["2 clips were compared with the dropped labels."]);
    await drop(labels("run.json", 8));
    expect(batchRows.value[1]?.source.labels).toHaveLength(1);
    expect(agreements()[1]).toBe(labels("run.json", 8).size);
  });

  it("are reported if they do not change the score", async () => {
    await drop(new File(["{}"], "run.json"));
    await drop(labels("run.json", 7));
    toasts.value = [];
    await drop(labels("run.json", 7));
    expect(texts()).toEqual([expect.stringMatching(/^The score of run\.bvh .*unchanged.*Open/)]);
  });

  it("are reported if they belong to no clip of it", async () => {
    await drop(labels("other.json", 7), labels("another.json", 7));
    expect(errorReport.value?.name).toBe("other.json, another.json");
    expect(errorReport.value?.failure.message).toContain("no clip of the table");
  });

  it("are also compared with the open clip if they belong to it", async () => {
    const [row] = batchRows.value;
    if (row) await openRow(row);
    tableVisible.value = true;
    await drop(labels("walk.json", 720));
    expect(agreements()[0]).toBeGreaterThan(0);
    expect(reference.value?.name).toBe("walk.json");
  });
});
