import type { Engine } from "../../worker/engine";
import type { Clip, Detection, Labelling, Tracks } from "../../worker/types";
import { walker, walkerTrack } from "./walker";

const pause = (ms: number) => new Promise((done) => setTimeout(done, ms));

/**
 * An engine for tests, made of a walking figure. The file's name chooses what happens:
 * `bad` cannot be read, `crab` has no feet, `rest` has no frames, `slow` takes a while.
 */
export function createEngine(): Engine {
  let clip: Clip | undefined;
  let other: Labelling | undefined;
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
      for (let i = 1; i <= 10 && name.includes("slow"); i++) {
        await pause(200);
        onProgress?.(i / 10);
      }
      other = undefined;
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
    async detect(options) {
      const { method, r } = options;
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
    async methods() {
      const method = { about: "A method for tests.", parts: ["toe" as const] };
      return [
        { ...method, name: "robust", title: "Robust spectral", family: "spectral" },
        { ...method, name: "paper", title: "Paper (2014)", family: "spectral" },
        { ...method, name: "dual", title: "Height and speed", family: "threshold" },
      ];
    },
    async compare(text, name) {
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
    async save(format) {
      return `{"made up": "${format}"}`;
    },
    cancel() {
      clip = undefined;
    },
  };
}
