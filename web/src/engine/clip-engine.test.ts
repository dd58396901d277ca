import { expect, test, vi } from "vitest";
import type {
  Annotation,
  Clip,
  Detection,
  Failure,
  SegmentAnnotation,
  Segmentation,
} from "../model/types";
import type { ClipApi } from "../workers/clip.worker";
import { Cancelled, createEngine } from "./clip-engine";
import type { WorkerHandle } from "./worker-handle";

const failure: Failure = { message: "no" };

/** Creates a fake worker that logs its calls; opening "bad" fails, and "slow" never settles. */
function fakeCalls(log: string[]) {
  let openName = "";
  let isBusy = false;
  const opened = () => ({ ok: true, clip: { name: openName } as Clip }) as const;
  const calls: WorkerHandle<ClipApi>["calls"] = {
    holdLock: async () => false,
    startWasm() {},
    async startSecondModule() {},
    async open(_, name) {
      log.push(`open ${name}`);
      if (name === "bad") return { ok: false, failure };
      if (name === "slow") return new Promise(() => {});
      openName = name;
      return opened();
    },
    async override(overrides) {
      log.push(`override ${overrides.rate}`);
      if (overrides.rate === 0) return { ok: false, failure };
      return opened();
    },
    async detect({ method }) {
      if (isBusy) return new Promise(() => {});
      log.push(`detect ${openName}`);
      isBusy = method === "njw";
      if (isBusy) return new Promise(() => {});
      if (!openName) throw new Error("No clip is open.");
      return { ok: true, detection: {} as Detection };
    },
    async segment({ method }) {
      log.push(`segment ${method}`);
      isBusy = method === "mvu";
      if (isBusy) return new Promise(() => {});
      if (method === "pca") return { ok: false, failure };
      return { ok: true, segmentation: {} as Segmentation };
    },
    async edit(edits) {
      log.push(`edit ${edits.length}`);
      return {};
    },
    evidence: async () => undefined,
    referenceEdits: async () => [],
    editCuts: async () => [],
    hash: async () => undefined,
    methods: async () => [],
    segmentMethods: async () => [],
    plantFormats: async () => [],
    segmentFormats: async () => [],
    async compare(file) {
      const text = await file.text();
      log.push(`compare ${text}`);
      if (text === "cuts") return { ok: true, segments: {} as SegmentAnnotation };
      return { ok: true, annotation: {} as Annotation };
    },
    gait: async () => undefined,
    gaitFormats: async () => [],
    saveGait: async () => "",
    skate: async () => [],
    similar: async () => undefined,
    clean: async () => ({ positions: new Float32Array(), plants: [], notices: [] }),
    saveCleaned: async () => new Blob(),
    score: async () => [],
    scoreSegments: async () => [],
    async saveSegments() {
      log.push("save segments");
      return new Uint8Array();
    },
    cut: async () => new Blob(),
    async save() {
      if (isBusy) return new Promise(() => {});
      if (log.includes("trap"))
        throw Object.assign(new Error("unreachable"), { name: "RuntimeError" });
      log.push(`save ${openName}`);
      return new TextEncoder().encode(openName);
    },
  };
  return calls;
}

function fakeEngine() {
  const log: string[] = [];
  const stops: (() => void)[] = [];
  const engine = createEngine((onBroken) => {
    log.push("start");
    const stop = vi.fn();
    stops.push(() => onBroken(new Error("broken")));
    return { calls: fakeCalls(log), stop };
  });
  return { log, engine, breakLast: () => stops.at(-1)?.() };
}

const file = new Blob([]);
const options = { method: "robust", r: 0.001, w: 1 };

test("restores the open clip in a new worker once, before other calls", async () => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  await engine.override({ rate: 30 });
  await engine.edit([{ side: "left", part: "toe", start: 0, end: 3, planted: true }]);
  await engine.detect(options);
  await engine.compare(new Blob(["truth"]), "truth.json");
  engine.cancel();
  await Promise.all([engine.save("csv"), engine.save("json")]);
  const restored = ["start", "open walk", "override 30", "edit 1", "detect walk", "compare truth"];
  expect(log).toEqual([...restored, ...restored, "save walk", "save walk"]);
});

test("leaves the clip open if another file cannot be read", async () => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  const slow = engine.open(file, "slow");
  await Promise.resolve();
  engine.cancel();
  await expect(slow).rejects.toBeInstanceOf(Cancelled);
  expect((await engine.open(file, "bad")).ok).toBe(false);
  await engine.detect(options);
  expect(log.at(-1)).toBe("detect walk");
});

test("does not compare a clip with the reference of the one before", async () => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  const compared = engine.compare(new Blob(["truth"]), "truth.json");
  await engine.open(file, "run");
  await compared;
  engine.cancel();
  await engine.detect(options);
  expect(log.slice(log.lastIndexOf("start"))).toEqual(["start", "open run", "detect run"]);
});

test("does not restore a clip that is replaced", async () => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  engine.cancel();
  await engine.open(file, "run");
  await engine.detect(options);
  expect(log.slice(2)).toEqual(["start", "open run", "detect run"]);
});

test("replaces a worker that fails", async () => {
  const { log, engine, breakLast } = fakeEngine();
  await engine.open(file, "walk");
  breakLast();
  await engine.detect(options);
  log.push("trap");
  await expect(engine.save("csv")).rejects.toThrow("unreachable");
  log.splice(log.indexOf("trap"), 1);
  expect(new TextDecoder().decode(await engine.save("csv"))).toBe("walk");
  expect(log.filter((entry) => entry === "start")).toHaveLength(3);
});

test("restores the segmentation only for calls that need it", async () => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  await engine.segment({ method: "auto" });
  await engine.compare(new Blob(["cuts"]), "cuts.csv");
  engine.cancel();
  await engine.detect(options);
  expect(log.slice(4)).toEqual(["start", "open walk", "compare cuts", "detect walk"]);
  await engine.saveSegments("json", [], []);
  await engine.saveSegments("csv", [], []);
  expect(log.slice(8)).toEqual(["segment auto", "save segments", "save segments"]);
});

test("stops a segmentation and repeats other pending calls", async () => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  await engine.segment({ method: "auto" });
  const controller = new AbortController();
  const pending = engine.segment({ method: "mvu" }, { signal: controller.signal });
  const stopped = expect(pending).rejects.toBeInstanceOf(Cancelled);
  const detected = engine.detect(options);
  await vi.waitFor(() => expect(log.at(-1)).toBe("segment mvu"));
  controller.abort();
  await stopped;
  expect((await detected).ok).toBe(true);
  expect(log.slice(3)).toEqual(["segment mvu", "start", "open walk", "detect walk"]);
  await engine.saveSegments("json", [], []);
  expect(log.slice(7)).toEqual(["segment auto", "save segments"]);
  const late = engine.segment({ method: "auto" }, { signal: controller.signal });
  await expect(late).rejects.toBeInstanceOf(Cancelled);
});

test("stops a detection and restores the previous one", async () => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  await engine.detect(options);
  const controller = new AbortController();
  const pending = engine.detect({ ...options, method: "njw" }, { signal: controller.signal });
  const saved = engine.save("csv");
  await vi.waitFor(() => expect(log.filter((entry) => entry === "detect walk")).toHaveLength(2));
  controller.abort();
  await expect(pending).rejects.toBeInstanceOf(Cancelled);
  await saved;
  expect(log.slice(-4)).toEqual(["start", "open walk", "detect walk", "save walk"]);
});

test.each([
  { method: "lsd", ok: true, calls: ["segment lsd", "save segments"] },
  { method: "pca", ok: false, calls: ["segment pca", "segment auto", "save segments"] },
])("saves the new segmentation, or the previous one if it fails: $method", async (segmentation) => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  await engine.segment({ method: "auto" });
  engine.cancel();
  const segmented = engine.segment({ method: segmentation.method });
  await engine.saveSegments("json", [], []);
  expect((await segmented).ok).toBe(segmentation.ok);
  expect(log.slice(3)).toEqual(["start", "open walk", ...segmentation.calls]);
});

/**
 * Opens "walk", and makes a call that ends with the worker, which a segmentation occupies. Returns the log from the
 * time at which the segmentation is stopped.
 */
async function stopWhilePending() {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  const controller = new AbortController();
  const { signal } = controller;
  const segmented = engine.segment({ method: "mvu" }, { signal }).catch((error) => error);
  const saved = engine.save("csv").catch((error) => error);
  await vi.waitFor(() => expect(log.at(-1)).toBe("segment mvu"));
  log.length = 0;
  controller.abort();
  return { log, engine, segmented, saved };
}

test("does not read the previous clip while another one is opened", async () => {
  const { log, engine, saved } = await stopWhilePending();
  await engine.open(file, "run");
  expect(await saved).toBeInstanceOf(Cancelled);
  await engine.detect(options);
  expect(log).toEqual(["start", "open run", "detect run"]);
});

test("repeats calls for the previous clip if the other one cannot be read", async () => {
  const { log, engine, saved } = await stopWhilePending();
  expect((await engine.open(file, "bad")).ok).toBe(false);
  expect(new TextDecoder().decode(await saved)).toBe("walk");
  expect(log).toEqual(["start", "open bad", "open walk", "save walk"]);
});

test("stops restoring a clip when another one is opened", async () => {
  const { log, engine, saved } = await stopWhilePending();
  while (log.at(-1) !== "open walk") await Promise.resolve();
  await engine.open(file, "run");
  expect(await saved).toBeInstanceOf(Cancelled);
  expect(log).toEqual(["start", "open walk", "start", "open run"]);
});

test("leaves the previous clip open if the opening is aborted", async () => {
  const { log, engine } = fakeEngine();
  await engine.open(file, "walk");
  const controller = new AbortController();
  const slow = engine.open(file, "slow", { signal: controller.signal });
  const edited = engine.edit([]);
  await Promise.resolve();
  controller.abort();
  await expect(slow).rejects.toBeInstanceOf(Cancelled);
  await edited;
  expect(log.slice(2)).toEqual(["open slow", "start", "open walk", "edit 0", "edit 0"]);
});

test("opens a clip with overrides, or without if they cannot be applied", async () => {
  const { log, engine } = fakeEngine();
  expect(await engine.open(file, "walk", { overrides: { rate: 30 } })).toMatchObject({ ok: true });
  engine.cancel();
  await engine.detect(options);
  const opened = ["start", "open walk", "override 30"];
  expect(log).toEqual([...opened, ...opened, "detect walk"]);
  const rejected = await engine.open(file, "walk", { overrides: { rate: 0 } });
  expect(rejected).toMatchObject({ ok: true, rejected: failure });
  engine.cancel();
  await engine.detect(options);
  expect(log.slice(7)).toEqual(["open walk", "override 0", "start", "open walk", "detect walk"]);
});
