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

/** A worker that writes down what it is told; opening "bad" fails, and "slow" never ends. */
function worker(said: string[]) {
  let held = "";
  let isBusy = false;
  const opened = () => ({ ok: true, clip: { name: held } as Clip }) as const;
  const calls: WorkerHandle<ClipApi>["calls"] = {
    startWasm() {},
    async open(_, name) {
      said.push(`open ${name}`);
      if (name === "bad") return { ok: false, failure };
      if (name === "slow") return new Promise(() => {});
      held = name;
      return opened();
    },
    async override(overrides) {
      said.push(`override ${overrides.rate}`);
      return opened();
    },
    async detect({ method }) {
      if (isBusy) return new Promise(() => {});
      said.push(`detect ${held}`);
      isBusy = method === "njw";
      if (isBusy) return new Promise(() => {});
      if (!held) throw new Error("No clip is open.");
      return { ok: true, detection: {} as Detection };
    },
    async segment({ method }) {
      said.push(`segment ${method}`);
      isBusy = method === "mvu";
      if (isBusy) return new Promise(() => {});
      if (method === "pca") return { ok: false, failure };
      return { ok: true, segmentation: {} as Segmentation };
    },
    async edit(edits) {
      said.push(`edit ${edits.length}`);
      return {};
    },
    evidence: async () => undefined,
    referenceEdits: async () => [],
    hash: async () => undefined,
    methods: async () => [],
    segmentMethods: async () => [],
    plantFormats: async () => [],
    segmentFormats: async () => [],
    async compare(file) {
      const text = await file.text();
      said.push(`compare ${text}`);
      if (text === "cuts") return { ok: true, segments: {} as SegmentAnnotation };
      return { ok: true, annotation: {} as Annotation };
    },
    gait: async () => undefined,
    skate: async () => [],
    clean: async () => ({ positions: new Float32Array(), plants: [], notices: [] }),
    saveCleaned: async () => new Blob(),
    score: async () => [],
    scoreSegments: async () => [],
    async saveSegments() {
      said.push("save segments");
      return "";
    },
    cut: async () => new Blob(),
    async save() {
      if (isBusy) return new Promise(() => {});
      if (said.includes("trap"))
        throw Object.assign(new Error("unreachable"), { name: "RuntimeError" });
      said.push(`save ${held}`);
      return new TextEncoder().encode(held);
    },
  };
  return calls;
}

function engine() {
  const said: string[] = [];
  const stops: (() => void)[] = [];
  const made = createEngine((onBroken) => {
    said.push("start");
    const stop = vi.fn();
    stops.push(() => onBroken(new Error("broken")));
    return { calls: worker(said), stop };
  });
  return { said, made, breakLast: () => stops.at(-1)?.() };
}

const file = new Blob([]);
const options = { method: "robust", r: 0.001, w: 1 };

test("a new worker is told what the old one held, once and before anything else", async () => {
  const { said, made } = engine();
  await made.open(file, "walk");
  await made.override({ rate: 30 });
  await made.edit([{ side: "left", part: "toe", start: 0, end: 3, planted: true }]);
  await made.detect(options);
  await made.compare(new Blob(["truth"]), "truth.json");
  made.cancel();
  await Promise.all([made.save("csv"), made.save("json")]);
  const told = ["start", "open walk", "override 30", "edit 1", "detect walk", "compare truth"];
  expect(said).toEqual([...told, ...told, "save walk", "save walk"]);
});

test("a file that cannot be read leaves the clip before at hand, also in a new worker", async () => {
  const { said, made } = engine();
  await made.open(file, "walk");
  const slow = made.open(file, "slow");
  await Promise.resolve();
  made.cancel();
  await expect(slow).rejects.toBeInstanceOf(Cancelled);
  expect((await made.open(file, "bad")).ok).toBe(false);
  await made.detect(options);
  expect(said.at(-1)).toBe("detect walk");
});

test("a clip that is opened takes the place of what the old worker held", async () => {
  const { said, made } = engine();
  await made.open(file, "walk");
  made.cancel();
  await made.open(file, "run");
  await made.detect(options);
  expect(said.slice(2)).toEqual(["start", "open run", "detect run"]);
});

test("a worker that breaks is replaced", async () => {
  const { said, made, breakLast } = engine();
  await made.open(file, "walk");
  breakLast();
  await made.detect(options);
  said.push("trap");
  await expect(made.save("csv")).rejects.toThrow("unreachable");
  said.splice(said.indexOf("trap"), 1);
  expect(new TextDecoder().decode(await made.save("csv"))).toBe("walk");
  expect(said.filter((word) => word === "start")).toHaveLength(3);
});

test("segments are found again only by a new worker that needs them", async () => {
  const { said, made } = engine();
  await made.open(file, "walk");
  await made.segment({ method: "auto" });
  await made.compare(new Blob(["cuts"]), "cuts.csv");
  made.cancel();
  await made.detect(options);
  expect(said.slice(4)).toEqual(["start", "open walk", "compare cuts", "detect walk"]);
  await made.saveSegments("json", []);
  await made.saveSegments("csv", []);
  expect(said.slice(8)).toEqual(["segment auto", "save segments", "save segments"]);
});

test("a segmentation can be stopped; what else was asked is asked of the next worker", async () => {
  const { said, made } = engine();
  await made.open(file, "walk");
  await made.segment({ method: "auto" });
  const stop = new AbortController();
  const endless = made.segment({ method: "mvu" }, { signal: stop.signal });
  const stopped = expect(endless).rejects.toBeInstanceOf(Cancelled);
  const detected = made.detect(options);
  await vi.waitFor(() => expect(said.at(-1)).toBe("segment mvu"));
  stop.abort();
  await stopped;
  expect((await detected).ok).toBe(true);
  expect(said.slice(3)).toEqual(["segment mvu", "start", "open walk", "detect walk"]);
  await made.saveSegments("json", []);
  expect(said.slice(7)).toEqual(["segment auto", "save segments"]);
  const late = made.segment({ method: "auto" }, { signal: stop.signal });
  await expect(late).rejects.toBeInstanceOf(Cancelled);
});

test("a detection can be stopped, and the labels before are had again", async () => {
  const { said, made } = engine();
  await made.open(file, "walk");
  await made.detect(options);
  const stop = new AbortController();
  const endless = made.detect({ ...options, method: "njw" }, { signal: stop.signal });
  const saved = made.save("csv");
  await vi.waitFor(() => expect(said.filter((word) => word === "detect walk")).toHaveLength(2));
  stop.abort();
  await expect(endless).rejects.toBeInstanceOf(Cancelled);
  await saved;
  expect(said.slice(-4)).toEqual(["start", "open walk", "detect walk", "save walk"]);
});

test.each([
  { method: "lsd", ok: true, told: ["segment lsd", "save segments"] },
  { method: "pca", ok: false, told: ["segment pca", "segment auto", "save segments"] },
])(
  "who saves while a new worker finds segments gets them, or those before: $method",
  async (cut) => {
    const { said, made } = engine();
    await made.open(file, "walk");
    await made.segment({ method: "auto" });
    made.cancel();
    const found = made.segment({ method: cut.method });
    await made.saveSegments("json", []);
    expect((await found).ok).toBe(cut.ok);
    expect(said.slice(3)).toEqual(["start", "open walk", ...cut.told]);
  },
);
