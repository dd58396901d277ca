/** Replacement of `engine` for tests: returns data of a generated walk, without workers and wasm. */

import { Cancelled, type ClipEngine } from "../engine/clip-engine";
import type { Annotation, Clip, Detection, SegmentAnnotation, Tracks } from "../model/types";
import { createWalkingClip, createWalkingTrack } from "./walking-clip";

export { Cancelled, Superseded } from "../engine/clip-engine";

/** Returns a promise that is never fulfilled, and rejected when the signal aborts. */
const waitForAbort = (signal?: AbortSignal) =>
  new Promise<never>((_, reject) => {
    signal?.addEventListener("abort", () => reject(new Cancelled()));
  });

/**
 * Creates an engine whose behaviour depends on the file name: `bad` cannot be read, `crab` has no
 * feet, `rest` has no frames, `slow` is never read. Segments are as long as the method name has
 * letters, in seconds; the methods `mvu` and `njw` never end.
 */
export function createFakeEngine(): ClipEngine {
  let clip: Clip | undefined;
  let annotation: Annotation | undefined;
  let segmentAnnotation: SegmentAnnotation | undefined;
  return {
    start() {},
    async open(_file, name, { signal, onProgress } = {}) {
      if (name.includes("bad")) {
        return {
          ok: false,
          failure: {
            message: 'expected a number, found "abc" (frame 389, channel LeftFoot Zrotation)',
            line: 466,
            column: 33,
            excerpt: "0.1 0.22 0.333 12.5 -3.25 1.0 0 abc 0.5 0.6 0.7",
            hint: "Export the clip again, repair the line in a text editor, or open it leniently.",
          },
        };
      }
      if (name.includes("slow")) {
        onProgress?.(0.1);
        await waitForAbort(signal);
      }
      annotation = undefined;
      segmentAnnotation = undefined;
      clip = createWalkingClip(name, name.includes("rest") ? 0 : 12);
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
      if (method === "njw") await waitForAbort(signal);
      if (!clip || clip.frames === 0 || clip.roles.left_ankle === undefined) {
        return {
          ok: false,
          failure: {
            message: clip?.frames ? "no feet detected in this skeleton" : "the clip has no frames",
            hint: clip?.frames
              ? "Name the ankles and toes under Clip."
              : "Only its rest pose is shown.",
          },
        };
      }
      const growth = Math.log(r / 0.001) * 1.5;
      const source = clip;
      const createTracks = (
        from: number,
        to: number,
        joints: readonly [number, number],
      ): Tracks => ({
        left: createWalkingTrack(source, 0, from, to, growth, joints[0]),
        right: createWalkingTrack(source, 0.5, from, to, growth, joints[1]),
      });
      const toe = createTracks(0.08, 0.6, [17, 22]);
      const heel = createTracks(0.02, 0.44, [16, 21]);
      const contact = createTracks(0.02, 0.6, [17, 22]);
      const detection: Detection = {
        options,
        parts: method === "paper" ? { toe } : { contact, toe, heel },
        floor: 0,
        ground: { normal: [0, 1, 0], origin: [0, 0, 0], tilt: 0, levels: [0] },
        notices: [],
      };
      return { ok: true, detection };
    },
    // Edits leave the labels unchanged.
    edit: async () => ({}),
    evidence: async () => undefined,
    referenceEdits: async () => [],
    similar: async () => undefined,
    editCuts: async () => [],
    hash: async () => undefined,
    async methods() {
      const method = { description: "A method for tests.", parts: ["toe" as const] };
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
        return waitForAbort(signal);
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
            title: "Test curve",
            frames: Float32Array.from(starts),
            values: Float32Array.from(starts),
            threshold: new Float32Array(0),
            extrema: new Uint32Array(0),
          },
          notices: [],
        },
      });
    },
    plantFormats: async () => [],
    segmentFormats: async () => [],
    async segmentMethods() {
      const method = { description: "A method for tests.", options: [] };
      return [
        { ...method, name: "auto", title: "Gaussian segments" },
        { ...method, name: "mvu", title: "Never ends" },
      ];
    },
    async compare(file, name) {
      const text = await file.text();
      if (text.includes("segments")) {
        segmentAnnotation = { name, segments: JSON.parse(text).segments };
        return { ok: true, segments: segmentAnnotation };
      }
      const labels = JSON.parse(text) as { left: number[]; right: number[] };
      if (labels.left.length !== clip?.frames) {
        return {
          ok: false,
          failure: { message: `the labels have ${labels.left.length} frames, the clip has not` },
        };
      }
      const feet = { left: Int8Array.from(labels.left), right: Int8Array.from(labels.right) };
      annotation = { name, parts: { toe: feet } };
      return { ok: true, annotation };
    },
    gait: async () => undefined,
    gaitFormats: async () => [],
    saveGait: async () => "",
    skate: async () => [],
    clean: async () => ({
      positions: clip?.positions ?? new Float32Array(),
      plants: [],
      notices: [],
    }),
    saveCleaned: async () => new Blob(["HIERARCHY"]),
    async score() {
      if (!annotation) return [];
      const disagreement = { side: "left", part: "toe", kind: "missed" } as const;
      return [
        {
          part: "toe",
          rows: [{ fuzzy: 0, lenient: 0.9, strict: 0.8, left: 0.9, right: 0.9 }],
          events: { precision: 1, recall: 0.5, f1: 2 / 3, onset: 0.02, offset: -0.01 },
          disagreements: [
            { ...disagreement, start: 10, end: 14 },
            { ...disagreement, start: 90, end: 92 },
          ],
        },
      ];
    },
    async scoreSegments() {
      return segmentAnnotation ? [{ within: 0.5, precision: 1, recall: 0.5, f1: 2 / 3 }] : [];
    },
    saveSegments: async (format, names, actions) =>
      new TextEncoder().encode(JSON.stringify({ format, names, actions })),
    cut: async (parts) => new Blob(parts.map(({ name }) => name)),
    save: async (format) => new TextEncoder().encode(`{"format": "${format}"}`),
    cancel() {},
  };
}

export const engine = createFakeEngine();

/** Summarises every file except those named `bad`. */
export const batchWorkers = {
  run: async (job: (calls: unknown) => Promise<unknown>) =>
    job({
      async summarize(_file: Blob, name: string) {
        if (name.includes("bad")) return { ok: false, failure: { message: "it is bad" } };
        const summary = {
          frames: 720,
          rate: 60,
          notices: 0,
          missing: [],
          edited: false,
          elapsedMs: 1,
        };
        return { ok: true, summary, files: [] };
      },
      commonActions: async () => [],
    }),
};

/** Rejects every archive. */
export const zipWorkers = {
  run: async () => ({ ok: false, failure: { message: "no archive" } }),
};
