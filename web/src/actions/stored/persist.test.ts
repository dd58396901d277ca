import { beforeEach, expect, test, vi } from "vitest";
import { ClipSession, openSession, session } from "../../store/clip-session";
import { edit } from "../../testing/edit";
import { engine } from "../../testing/fake-engine";
import { createWalkingClip } from "../../testing/walking-clip";

vi.mock("../../engine", () => import("../../testing/fake-engine"));

const { commitEdits, undo } = await import("../edit/edit");
const { restorePersisted } = await import("./persist");
const { dismissSimilar } = await import("../edit/similar");

const key = "plantigrade:clip:abc";
const stored = () => JSON.parse(localStorage.getItem(key) ?? "null");

const openClip = () =>
  openSession(
    new ClipSession(createWalkingClip("walk.bvh"), { name: "walk.bvh", data: new Blob() }),
  );

beforeEach(() => {
  localStorage.clear();
  openClip();
});

test("merges edits that were made before the hash of the file was known", async () => {
  const record = { version: 1, name: "walk.bvh", edits: [edit(0)], names: [] };
  localStorage.setItem(key, JSON.stringify(record));
  let resolve: (hash: string) => void = () => {};
  const hash = new Promise<string>((resolveHash) => {
    resolve = resolveHash;
  });
  vi.spyOn(engine, "hash").mockReturnValueOnce(hash);
  const restored = restorePersisted();
  await commitEdits([edit(50)], "");
  resolve("abc");
  await restored;
  expect(session.value.edits.value).toEqual([edit(0), edit(50)]);
  expect(stored().edits).toEqual([edit(0), edit(50)]);
  await undo();
  expect(session.value.edits.value).toEqual([edit(0)]);
  expect(stored().edits).toEqual([edit(0)]);
});

test("asks for the hash again if the worker is stopped", async () => {
  vi.spyOn(engine, "hash").mockRejectedValueOnce(new Error("stopped")).mockResolvedValueOnce("abc");
  await restorePersisted();
  await commitEdits([edit(0)], "");
  expect(stored()).toMatchObject({ version: 5, edits: [edit(0)] });
});

test("stores that similar plants are settled, until the next edit", async () => {
  vi.spyOn(engine, "hash").mockResolvedValue("abc");
  const isSettled = () =>
    session.value.similarSettledFor.value === session.value.edits.value &&
    stored().similarSettled === true;
  await restorePersisted();
  await commitEdits([edit(0)], "");
  expect(stored()).toMatchObject({ similarSettled: false });
  dismissSimilar();
  expect(isSettled()).toBe(true);
  openClip();
  await restorePersisted();
  expect(session.value.edits.value).toEqual([edit(0)]);
  expect(isSettled()).toBe(true);
  await commitEdits([edit(0), edit(20)], "");
  expect(isSettled()).toBe(false);
  await undo();
  expect(isSettled()).toBe(true);
});

test("similar plants stay settled when cuts are edited", async () => {
  vi.spyOn(engine, "hash").mockResolvedValue("abc");
  await restorePersisted();
  await commitEdits([edit(0)], "");
  dismissSimilar();
  await commitEdits([edit(0), { cut: 12, present: true }], "");
  expect(stored()).toMatchObject({ similarSettled: true });
  openClip();
  await restorePersisted();
  expect(session.value.isSimilarSettled).toBe(true);
  await commitEdits([edit(0), { cut: 12, present: true }, edit(20)], "");
  expect(stored()).toMatchObject({ similarSettled: false });
});

test("reports edits of a file that cannot be identified", async () => {
  vi.spyOn(engine, "hash").mockRejectedValue(new Error("the file cannot be read"));
  await restorePersisted();
  expect(session.value.persistError.value).toBe("");
  await commitEdits([edit(0)], "");
  expect(session.value.persistError.value).toContain("the file cannot be read");
  await undo();
  expect(session.value.persistError.value).toBe("");
});

test("stores nothing for clips that are not edited", async () => {
  vi.spyOn(engine, "hash").mockResolvedValue("abc");
  await restorePersisted();
  expect(stored()).toBeNull();
});

test("forgets edits that could not be stored once they are undone", async () => {
  vi.spyOn(engine, "hash").mockResolvedValue("abc");
  await restorePersisted();
  const setItem = () => {
    throw new DOMException("full", "QuotaExceededError");
  };
  vi.stubGlobal("localStorage", { getItem: () => null, setItem });
  await commitEdits([edit(0)], "");
  expect(session.value.persistError.value).toContain("is full");
  await undo();
  expect(session.value.persistError.value).toBe("");
  vi.unstubAllGlobals();
  openClip();
  await restorePersisted();
  expect(session.value.edits.value).toEqual([]);
});
