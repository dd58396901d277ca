import { beforeEach, expect, it, vi } from "vitest";
import { ClipSession, openSession, session } from "../../store/clip-session";
import { namedSegments } from "../../store/session";
import { segmentOptions } from "../../store/settings";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { errorReport } = await import("../../store/errors");
const { openFiles } = await import("../open/open-files");
const { exportLabels } = await import("./export");
const { exportClips, exportSegments } = await import("./export-segments");

const open = (name: string) => openFiles({ files: [new File(["HIERARCHY"], name)] });
const format = { name: "json", title: "", description: "", extension: "json", mediaType: "" };
const saved: string[] = [];

beforeEach(async () => {
  saved.length = 0;
  URL.createObjectURL = () => "blob:";
  vi.spyOn(HTMLAnchorElement.prototype, "click").mockImplementation(function (
    this: HTMLAnchorElement,
  ) {
    saved.push(this.download);
  });
  segmentOptions.value = { method: "auto" };
  errorReport.value = null;
  await open("walk.bvh");
});

it("saves the open clip when its edits are applied", async () => {
  await exportLabels(format);
  await exportSegments(format);
  await exportClips();
  expect(namedSegments.value).toHaveLength(3);
  expect(saved).toEqual(["walk.json", "walk.json", "walk.segments.zip"]);
  expect(errorReport.value).toBeNull();
});

it.each([
  ["labels", () => exportLabels(format)],
  ["segments", () => exportSegments(format)],
  ["clips of segments", exportClips],
])("does not save the %s of another clip under the name of the one before", async (_, save) => {
  let apply = () => {};
  session.value.delayEdits(
    new Promise<void>((resolve) => {
      apply = resolve;
    }),
  );
  const pending = save();
  openSession(new ClipSession(null, null));
  apply();
  await pending;
  expect(saved).toEqual([]);
  expect(errorReport.value?.name).toMatch(/^walk\./);
  expect(errorReport.value?.action).toBe("saved");
});
