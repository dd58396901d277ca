import { beforeEach, describe, expect, it, vi } from "vitest";
import { maxFileBytes } from "../../model/limits";
import { type BatchRow, batchRows, tableVisible } from "../../store/batch";
import { timeView } from "../../store/playback";
import { detectFailure, detection, openClip, plants } from "../../store/session";
import { detectOptions } from "../../store/settings";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { errorReport } = await import("../../store/errors");
const { jobs, opening } = await import("../../store/jobs");
const { phase } = await import("../../store/phase");
const { session } = await import("../../store/clip-session");
const { toasts } = await import("../../store/toasts");
const { message, notify } = await import("../../store/view");
const { cancelOpening, openSample, openSource } = await import("./open");
const { openFiles } = await import("./open-files");
const { openRow } = await import("../analyse/batch");
const { detecting, runDetection, setDetectOptions } = await import("../analyse/detect");

const file = (name: string) => new File(["HIERARCHY"], name);

beforeEach(() => {
  errorReport.value = null;
  opening.value = null;
});

describe("opening", () => {
  it("shows the clip and its plants", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    expect(phase.value).toBe("ready");
    expect(openClip.value?.name).toBe("walk.bvh");
    expect(plants.value.length).toBeGreaterThan(10);
    expect(timeView.value).toEqual({ start: 0, end: 720 });
  });

  it("does not show what was done in the clip before", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    notify("Plant deleted");
    await openFiles({ files: [file("second.bvh")] });
    expect(message.value).toBe("");
  });

  it("waits for the edits of the clip before, and reports those that come later", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    const walk = session.value;
    let apply = () => {};
    const early = walk.inOrder(() => new Promise<void>((resolve) => (apply = resolve)));
    const opened = openFiles({ files: [file("second.bvh")] });
    await vi.waitFor(() => expect(opening.value?.name).toBe("second.bvh"));
    void walk.inOrder(() => new Promise(() => {}));
    expect(openClip.value?.name).toBe("walk.bvh");
    apply();
    await early;
    await opened;
    expect(openClip.value?.name).toBe("second.bvh");
    expect(toasts.value.map(({ text }) => text)).toEqual([
      "1 edit of walk.bvh came too late: another clip was being opened.",
    ]);
    toasts.value = [];
  });

  it("reports the failure and leaves the clip open", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    await openFiles({ files: [file("bad.bvh")] });
    expect(phase.value).toBe("error");
    expect(errorReport.value?.failure.line).toBe(466);
    expect(openClip.value?.name).toBe("walk.bvh");
  });

  it("lists several clips in a table", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    await openFiles({ files: [file("bad.bvh"), file("walk.bvh"), file("second.bvh")] });
    expect(tableVisible.value).toBe(true);
    expect(batchRows.value.map(({ source }) => source.name)).toEqual([
      "bad.bvh",
      "walk.bvh",
      "second.bvh",
    ]);
    expect(batchRows.value.map(({ status }) => status)).toEqual(["failed", "done", "done"]);
    expect(openClip.value?.name).toBe("walk.bvh");
    await openRow(batchRows.value[2] as BatchRow);
    expect(tableVisible.value).toBe(false);
    expect(openClip.value?.name).toBe("second.bvh");
  });

  it("does not replace a table that was dropped meanwhile", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    let apply = () => {};
    void session.value.inOrder(() => new Promise<void>((resolve) => (apply = resolve)));
    const opened = openFiles({ files: [file("second.bvh")] });
    await vi.waitFor(() => expect(opening.value?.name).toBe("second.bvh"));
    await openFiles({ files: [file("run.bvh"), file("jump.bvh")] });
    apply();
    await opened;
    expect(openClip.value?.name).toBe("second.bvh");
    expect(tableVisible.value).toBe(true);
    tableVisible.value = false;
  });

  it("shows a clip in place of the table when another attempt succeeds", async () => {
    await openFiles({ files: [file("walk.bvh"), file("bad.bvh")] });
    const row = batchRows.value[1] as BatchRow;
    expect(await openRow(row)).toBe(false);
    expect(tableVisible.value).toBe(true);
    // As if it was read leniently.
    row.source.name = "repaired.bvh";
    errorReport.value?.openLeniently?.();
    await vi.waitFor(() => expect(tableVisible.value).toBe(false));
    expect(openClip.value?.name).toBe("repaired.bvh");
    await vi.waitFor(() => expect(batchRows.value[1]?.status).toBe("done"));
    expect(batchRows.value[1]?.failure).toBeUndefined();
  });

  it("refuses a file above the size limit before reading it", async () => {
    const data = new Blob();
    Object.defineProperty(data, "size", { value: maxFileBytes + 1 });
    expect(await openSource({ name: "huge.bvh", data })).toBe(false);
    expect(errorReport.value?.failure.message).toContain("limit");
  });

  it("can be cancelled", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    const pending = openFiles({ files: [file("slow.bvh")] });
    await vi.waitFor(() => expect(phase.value).toBe("loading"));
    cancelOpening();
    await pending;
    expect(phase.value).toBe("ready");
    expect(openClip.value?.name).toBe("walk.bvh");
  });

  it("shows the progress of an opening next to the failure of another file", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    const pending = openFiles({ files: [file("slow.bvh")] });
    await vi.waitFor(() => expect(opening.value?.fraction).toBe(0.1));
    await openFiles({ files: [new File(["PK\u0003\u0004"], "broken.zip")] });
    expect(errorReport.value?.name).toBe("broken.zip");
    expect(opening.value?.name).toBe("slow.bvh");
    cancelOpening();
    await pending;
    expect(openClip.value?.name).toBe("walk.bvh");
  });

  it("ends the opening of another file when a file above the size limit is opened", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    const pending = openFiles({ files: [file("slow.bvh")] });
    await vi.waitFor(() => expect(opening.value?.fraction).toBe(0.1));
    const data = new Blob();
    Object.defineProperty(data, "size", { value: maxFileBytes + 1 });
    await openSource({ name: "huge.bvh", data });
    await pending;
    expect(opening.value).toBeNull();
    expect(errorReport.value?.name).toBe("huge.bvh");
  });

  it("reports an unknown sample", async () => {
    expect(await openSample("nobody")).toBe(false);
    expect(errorReport.value?.failure.message).toContain("nobody");
  });

  it("shows a clip without feet", async () => {
    await openFiles({ files: [file("crab.bvh")] });
    expect(openClip.value?.name).toBe("crab.bvh");
    expect(detection.value).toBeNull();
    expect(detectFailure.value?.message).toContain("no feet");
  });

  it("replaces the session, which ends its detection", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    const before = session.value;
    const labels = before.detection.value;
    const pending = runDetection({ method: "njw", r: 0.001, w: 1 });
    await openFiles({ files: [file("second.bvh")] });
    await pending;
    expect(before.signal.aborted).toBe(true);
    expect(before.detection.value).toBe(labels);
    expect(session.value).not.toBe(before);
    expect(openClip.value?.name).toBe("second.bvh");
    expect(detection.value?.options.method).toBe("robust");
  });
});

describe("detection", () => {
  it("runs again when a setting changes", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    setDetectOptions({ method: "paper" });
    await vi.waitFor(() => expect(detection.value?.options.method).toBe("paper"));
    expect(detection.value?.parts.heel).toBeUndefined();
    setDetectOptions({ method: "robust" });
  });

  it("leaves labels and settings unchanged when it is stopped", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    setDetectOptions({ method: "njw" });
    expect(detecting.value).toBe(true);
    await vi.waitFor(() => expect(jobs.value[0]?.title).toBe("Detecting plants in"));
    expect(phase.value).toBe("ready");
    jobs.value[0]?.stop();
    expect(detectOptions.value.method).toBe("robust");
    await vi.waitFor(() => expect(detecting.value).toBe(false));
    expect(detection.value?.options.method).toBe("robust");
    expect(jobs.value).toEqual([]);
  });

  it("leaves a new clip without labels when it is stopped, and reports that", async () => {
    detectOptions.value = { ...detectOptions.value, method: "njw" };
    const pending = openFiles({ files: [file("walk.bvh")] });
    await vi.waitFor(() => expect(opening.value?.stage).toBe("detect"));
    cancelOpening();
    await pending;
    expect(phase.value).toBe("ready");
    expect(openClip.value?.name).toBe("walk.bvh");
    expect(detectFailure.value?.message).toContain("cancelled");
    setDetectOptions({ method: "robust" });
    await vi.waitFor(() => expect(detection.value?.options.method).toBe("robust"));
  });

  it("is stopped for a new setting only if it is slow", async () => {
    await openFiles({ files: [file("walk.bvh")] });
    vi.useFakeTimers({ toFake: ["performance"] });
    setDetectOptions({ method: "njw" });
    setDetectOptions({ method: "paper" });
    await Promise.resolve();
    expect(jobs.value).toHaveLength(1);
    vi.advanceTimersByTime(3000);
    setDetectOptions({ method: "robust", r: 0.002 });
    vi.useRealTimers();
    await vi.waitFor(() => expect(detection.value?.options.r).toBe(0.002));
    setDetectOptions({ r: 0.001 });
  });
});
