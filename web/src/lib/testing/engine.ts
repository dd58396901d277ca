import { Cancelled, type Engine } from "../../worker/engine";
import type { Clip, Detection, Labelling, Segments, Tracks } from "../../worker/types";
import { walker, walkerTrack } from "./walker";

export { Cancelled } from "../../worker/engine";

const pause = (ms: number) => new Promise((done) => setTimeout(done, ms));

const endless = (signal?: AbortSignal) =>
  new Promise<never>((_, reject) => {
    signal?.addEventListener("abort", () => reject(new Cancelled()));
  });

/**
 * An engine for tests, made of a walking figure. The file's name chooses what happens:
 * `bad` cannot be read, `crab` has no feet, `rest` has no frames, `slow` takes a while.
 * Segments are as long as the method's name has letters, in seconds; `mvu` and `njw` never end.
 */
export function createEngine(): Engine {
  let clip: Clip | undefined;
  let other: Labelling | undefined;
  let otherSegments: Segments | undefined;
  let turn = 0;
  return {
    async open(_file, name, { onProgress } = {}) {
      if (name.includes("bad")) {
        return {
          ok: false,
          failure: {
            message: 'expected a number, found "abc" (frame 389, channel LeftFoot Zrotation)',
            line: 466,
            column: 33,
            excerpt: "0.1 0.22 0.333 12.5 -3.25 1.0 0 abc 0.5 0.6 0.7",
            hint: "Export the clip again, or repair the line in a text editor.",
          },
        };
      }
      const mine = ++turn;
      for (let i = 1; i <= 10 && name.includes("slow"); i++) {
        await pause(200);
        if (mine !== turn) throw new Cancelled();
        onProgress?.(i / 10);
      }
      other = undefined;
      otherSegments = undefined;
      clip = walker(name, name.includes("rest") ? 0 : 12);
      if (name.includes("crab")) clip.roles = { hips: 0 };
      return { ok: true, clip };
    },
    async override(overrides) {
      if (!clip) return { ok: false, failure: { message: "no clip is open" } };
      clip = { ...clip, rate: overrides.rate ?? 60, up: overrides.up ?? "y" };
      for (const [role, joint] of Object.entries(overrides.roles ?? {})) {
        clip.roles = { ...clip.roles, [role]: joint };
      }
      return { ok: true, clip };
    },
    async detect(options, { signal } = {}) {
      const { method, r } = options;
      if (method === "njw") await endless(signal);
      if (!clip || clip.frames === 0 || clip.roles.left_ankle === undefined) {
        return {
          ok: false,
          failure: {
            message: clip?.frames
              ? "no feet were found in this skeleton"
              : "the clip has no frames",
            hint: clip?.frames
              ? "Name the ankles and toes under Clip."
              : "Only its rest pose is shown.",
          },
        };
      }
      const grow = Math.log(r / 0.001) * 1.5;
      const held = clip;
      const part = (from: number, to: number, joints: readonly [number, number]): Tracks => ({
        left: walkerTrack(held, 0, from, to, grow, joints[0]),
        right: walkerTrack(held, 0.5, from, to, grow, joints[1]),
      });
      const toe = part(0.08, 0.6, [17, 22]);
      const heel = part(0.02, 0.44, [16, 21]);
      const contact = part(0.02, 0.6, [17, 22]);
      const detection: Detection = {
        options,
        parts: method === "paper" ? { toe } : { contact, toe, heel },
        floor: 0,
        notices: [],
      };
      return { ok: true, detection };
    },
    // Labels of tests stay as they are, whatever a person says.
    async edit() {
      return {};
    },
    async why() {
      return undefined;
    },
    async theirs() {
      return [];
    },
    async hash() {
      return undefined;
    },
    async methods() {
      const method = { about: "A method for tests.", parts: ["toe" as const] };
      return [
        { ...method, name: "robust", title: "Robust spectral", family: "spectral" },
        { ...method, name: "paper", title: "Paper (2014)", family: "spectral" },
        { ...method, name: "dual", title: "Height and speed", family: "threshold" },
      ];
    },
    segment(options, { signal, onProgress } = {}) {
      const { frames = 0, rate = 1 } = clip ?? {};
      if (options.method === "mvu") {
        onProgress?.(0.5);
        return endless(signal);
      }
      const step = options.method.length * rate;
      const starts = Array.from({ length: Math.ceil(frames / step) }, (_, i) => i * step);
      return Promise.resolve({
        ok: true,
        segmentation: {
          options,
          segments: starts.map((start) => ({
            start,
            end: Math.min(start + step, frames),
            kind: "action",
            label: "",
          })),
          transitions: new Uint32Array(0),
          motifs: new Uint32Array(0),
          classes: new Uint32Array(0),
          curve: {
            title: "Made up",
            frames: Float32Array.from(starts),
            values: Float32Array.from(starts),
            threshold: new Float32Array(0),
            extrema: new Uint32Array(0),
          },
          notices: [],
        },
      });
    },
    async segmentMethods() {
      const method = { about: "A method for tests.", options: [] };
      return [
        { ...method, name: "auto", title: "Gaussian segments" },
        { ...method, name: "mvu", title: "Never ends" },
      ];
    },
    async compare(file, name) {
      const text = await file.text();
      if (text.includes("segments")) {
        otherSegments = { name, segments: JSON.parse(text).segments };
        return { ok: true, segments: otherSegments };
      }
      const labels = JSON.parse(text) as { left: number[]; right: number[] };
      if (labels.left.length !== clip?.frames) {
        return {
          ok: false,
          failure: { message: `the labels have ${labels.left.length} frames, the clip has not` },
        };
      }
      const feet = { left: Int8Array.from(labels.left), right: Int8Array.from(labels.right) };
      other = { name, parts: { toe: feet } };
      return { ok: true, other };
    },
    async gait() {
      return undefined;
    },
    async skate() {
      return [];
    },
    async clean() {
      return { positions: clip?.positions ?? new Float32Array(), plants: [], notices: [] };
    },
    async saveCleaned() {
      return new Blob(["HIERARCHY"]);
    },
    async score() {
      if (!other) return [];
      const run = { side: "left", part: "toe", kind: "missed" } as const;
      return [
        {
          part: "toe",
          rows: [{ fuzzy: 0, lenient: 0.9, strict: 0.8, left: 0.9, right: 0.9 }],
          events: { precision: 1, recall: 0.5, f1: 2 / 3, onset: 0.02, offset: -0.01 },
          disagreements: [
            { ...run, start: 10, end: 14 },
            { ...run, start: 90, end: 92 },
          ],
        },
      ];
    },
    async scoreSegments() {
      return otherSegments ? [{ within: 0.5, precision: 1, recall: 0.5, f1: 2 / 3 }] : [];
    },
    async saveSegments(format, names) {
      return JSON.stringify({ format, names });
    },
    async cut(parts) {
      return new Blob(parts.map(({ name }) => name));
    },
    async save(format) {
      return new TextEncoder().encode(`{"made up": "${format}"}`);
    },
    cancel() {
      turn++;
    },
  };
}

/** Workers for tests: a file named `bad` cannot be surveyed, and there is no archive. */
export const surveyors = {
  run: async (job: (calls: unknown) => Promise<unknown>) =>
    job({
      async survey(_file: Blob, name: string) {
        if (name.includes("bad")) return { ok: false, failure: { message: "it is bad" } };
        const survey = { frames: 720, rate: 60, notices: 0, missing: [], edited: false, took: 1 };
        return { ok: true, survey, documents: [] };
      },
    }),
};

export const archivist = {
  run: async () => ({ ok: false, failure: { message: "no archive" } }),
};
