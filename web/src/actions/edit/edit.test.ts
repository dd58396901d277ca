import { expect, test, vi } from "vitest";
import type { EditedParts } from "../../model/types";
import { ClipSession, openSession, session } from "../../store/clip-session";
import { edits } from "../../store/session";
import { announcement, message } from "../../store/view";
import { edit } from "../../testing/edit";
import { engine } from "../../testing/fake-engine";
import { createWalkingClip } from "../../testing/walking-clip";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const {
  addToTarget,
  commitEdits,
  inOrder,
  nudgeEdge,
  redo,
  removeSelected,
  startAtPlayhead,
  undo,
} = await import("./edit");
const { openFiles } = await import("../open/open-files");

test("reports why there is no plant to edit", async () => {
  openSession(new ClipSession(createWalkingClip("walk.bvh"), null));
  for (const command of [startAtPlayhead, removeSelected, addToTarget, () => nudgeEdge(1)]) {
    message.value = "";
    await command();
    expect(message.value).toBe("There are no labels yet");
  }
  await openFiles({ files: [new File(["HIERARCHY"], "walk.bvh")] });
  for (const command of [startAtPlayhead, removeSelected]) {
    message.value = "";
    await command();
    expect(message.value).toBe("Select a plant first");
  }
});

test("edits wait for those of another page or of a notebook", async () => {
  await openFiles({ files: [new File(["HIERARCHY"], "walk.bvh")] });
  let answer: (parts: EditedParts) => void = () => {};
  const labels = new Promise<EditedParts>((resolve) => {
    answer = resolve;
  });
  vi.spyOn(engine, "edit").mockReturnValueOnce(labels);
  const steps: string[] = [];
  const remote = commitEdits([edit(0)], "").then(() => steps.push("remote"));
  const own = inOrder(() => steps.push("own"));
  answer({});
  await Promise.all([remote, own]);
  expect(steps).toEqual(["remote", "own"]);
});

test("does edits in order, also after one that failed, but not in the next clip", async () => {
  await openFiles({ files: [new File(["HIERARCHY"], "walk.bvh")] });
  vi.spyOn(engine, "edit").mockRejectedValueOnce(new Error("stopped"));
  const results: unknown[] = [];
  await Promise.allSettled([
    inOrder(() => commitEdits([edit(0)], "")),
    inOrder(() => Promise.reject(new Error("not done"))),
    inOrder(() => results.push(edits.value)),
  ]);
  expect(results).toEqual([[edit(0)]]);
  const late = inOrder(() => results.push("late"));
  openSession(new ClipSession(createWalkingClip("other.bvh"), null));
  await late;
  expect(results).toHaveLength(1);
  expect(session.value.edits.value).toEqual([]);
});

test("announces every undone and redone edit, and which it was", async () => {
  await openFiles({ files: [new File(["HIERARCHY"], "walk.bvh")] });
  const spoken: string[] = [];
  const stop = announcement.subscribe((text) => void spoken.push(text.trim()));
  spoken.length = 0;
  for (const start of [0, 20, 40]) await commitEdits([...edits.value, edit(start)], "Plant added");
  for (let i = 0; i < 3; i++) await undo();
  await redo();
  stop();
  expect(spoken).toEqual([
    ...Array(3).fill("Plant added"),
    ...Array(3).fill("Undone: Plant added"),
    "Redone: Plant added",
  ]);
  expect(message.value.trim()).toBe("Redone: Plant added");
});
