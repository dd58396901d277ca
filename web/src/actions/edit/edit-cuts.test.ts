import { beforeEach, expect, test, vi } from "vitest";
import { session } from "../../store/clip-session";
import { frame } from "../../store/playback";
import { cuts, edits, segmentation, selectedCut } from "../../store/session";
import { message } from "../../store/view";
import { engine } from "../../testing/fake-engine";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { redo, undo } = await import("./edit");
const { addCutAtPlayhead, moveCutTo, removeNearestCut, selectCut } = await import("./edit-cuts");
const { openFiles } = await import("../open/open-files");
const { seek } = await import("../view/playback");

beforeEach(async () => {
  await openFiles({ files: [new File(["HIERARCHY"], "walk.bvh")] });
  vi.spyOn(engine, "editCuts").mockImplementation(async (cutEdits) => {
    const starts = new Set([0, 240, 480]);
    for (const { cut, present } of cutEdits) {
      if (present) starts.add(cut);
      else starts.delete(cut);
    }
    const sorted = [...starts].sort((a, b) => a - b);
    return sorted.map((start, i) => ({
      start,
      end: sorted[i + 1] ?? 720,
      kind: "action",
      label: "",
    }));
  });
});

const addCutAt = (cut: number) => {
  seek(cut);
  return addCutAtPlayhead();
};

test("undo and redo select the moved cut", async () => {
  await addCutAt(45);
  await moveCutTo(45, 60);
  expect(cuts.value).toEqual([60, 240, 480]);
  await undo();
  expect(cuts.value).toEqual([45, 240, 480]);
  expect(selectedCut.value).toBe(45);
  await redo();
  expect(selectedCut.value).toBe(60);
});

test("undo of an added cut selects nothing", async () => {
  await addCutAt(45);
  expect(selectedCut.value).toBe(45);
  await undo();
  expect(cuts.value).toEqual([240, 480]);
  expect(selectedCut.value).toBeNull();
});

test("removing or moving a cut that does not exist does nothing", async () => {
  await addCutAt(45);
  await undo();
  selectCut(45);
  message.value = "";
  await removeNearestCut();
  expect(message.value).toBe("There is no cut to remove");
  await moveCutTo(45, 70);
  expect(edits.value).toEqual([]);
  expect(session.value.undoStack.value).toEqual([]);
  expect(session.value.redoStack.value).toHaveLength(1);
});

test("no cut is added without segments", async () => {
  segmentation.value = null;
  message.value = "";
  await addCutAt(20);
  expect(frame.value).toBe(20);
  expect(edits.value).toEqual([]);
  expect(message.value).toBe("There are no segments to cut");
});
