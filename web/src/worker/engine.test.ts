import { expect, test, vi } from "vitest";
import { Cancelled, createEngine, type Thread } from "./engine";
import type { Clip, Detection, Failure, Labelling } from "./types";

const failure: Failure = { message: "no" };

/** A worker that writes down what it is told; opening "bad" fails, and "slow" never ends. */
function worker(said: string[]) {
  let held = "";
  const opened = () => ({ ok: true, clip: { name: held } as Clip }) as const;
  const calls: Thread["calls"] = {
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
    async detect() {
      said.push(`detect ${held}`);
      if (!held) throw new Error("No clip is open.");
      return { ok: true, detection: {} as Detection };
    },
    methods: async () => [],
    async compare(text) {
      said.push(`compare ${text}`);
      return { ok: true, other: {} as Labelling };
    },
    score: async () => [],
    async save() {
      if (said.includes("trap"))
        throw Object.assign(new Error("unreachable"), { name: "RuntimeError" });
      said.push(`save ${held}`);
      return held;
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
  await made.detect(options);
  await made.compare("truth", "truth.json");
  made.cancel();
  await Promise.all([made.save("csv"), made.save("json")]);
  const told = ["start", "open walk", "override 30", "detect walk", "compare truth"];
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
  expect(await made.save("csv")).toBe("walk");
  expect(said.filter((word) => word === "start")).toHaveLength(3);
});
