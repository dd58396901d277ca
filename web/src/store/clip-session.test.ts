import { describe, expect, it } from "vitest";
import { ClipSession, openSession, session, sessionField } from "./clip-session";

const newSession = () => new ClipSession(null, { name: "walk.bvh", data: new Blob() });

/** Returns a promise with its functions. */
function deferred<T>() {
  let resolve: (value: T) => void = () => {};
  let reject: (reason: Error) => void = () => {};
  const promise = new Promise<T>((onResolve, onReject) => {
    resolve = onResolve;
    reject = onReject;
  });
  return { promise, resolve, reject };
}

describe("run", () => {
  it("returns results and errors while the clip is open", async () => {
    const open = newSession();
    expect(await open.run("detect", async () => 1)).toBe(1);
    const failing = open.run("detect", () => Promise.reject(new Error("no")));
    await expect(failing).rejects.toThrow("no");
  });

  it("drops results and errors once another clip is open", async () => {
    const before = newSession();
    openSession(before);
    const [answer, failure] = [deferred<number>(), deferred<number>()];
    const answered = before.run("detect", () => answer.promise);
    const failed = before.run("segment", () => failure.promise);
    openSession(newSession());
    answer.resolve(1);
    failure.reject(new Error("no"));
    expect(await answered).toBeUndefined();
    expect(await failed).toBeUndefined();
    expect(before.signal.aborted).toBe(true);
  });

  it("drops results of calls that a newer one replaces, or that are dropped", async () => {
    const open = newSession();
    const [first, second] = [deferred<number>(), deferred<number>()];
    const older = open.run("edit", () => first.promise);
    const newer = open.run("edit", () => second.promise);
    second.resolve(2);
    first.resolve(1);
    expect(await older).toBeUndefined();
    expect(await newer).toBe(2);
    const third = deferred<number>();
    const dropped = open.run("edit", () => third.promise);
    open.drop("edit");
    third.resolve(3);
    expect(await dropped).toBeUndefined();
  });
});

it("shows the fields of the open session", () => {
  const names = sessionField((open) => open.segmentNames);
  openSession(newSession());
  names.value = [{ start: 0, end: 9, name: "walk" }];
  expect(session.value.segmentNames.value).toHaveLength(1);
  openSession(newSession());
  expect(names.value).toEqual([]);
  expect(names.peek()).toEqual([]);
});
