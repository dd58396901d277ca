/** Functions measured by scripts/bench/core.mjs: the wasm module and three.js' loader. */

import { BVHLoader } from "three/examples/jsm/loaders/BVHLoader.js";
import init, {
  type DetectOptions,
  type WasmClip,
  WasmReader,
} from "../../web/src/wasm/plantigrade";
import { readChunks } from "../../web/src/workers/read-blob";
import { rewriteFile } from "../../web/src/workers/rewrite-file";

const { memory } = await init();

let clip: WasmClip | undefined;
let clipFile: Blob | undefined;

/** Reads a file as the app's worker does. */
async function read(file: Blob): Promise<WasmClip> {
  const reader = new WasmReader(false, file.size);
  for await (const chunk of readChunks(file)) reader.push(chunk);
  return reader.finish();
}

/** Returns the time of the fastest of several runs, in milliseconds, and the result of the last. */
async function bestTime<T>(runs: number, run: () => T | Promise<T>): Promise<[number, T]> {
  let best = Number.POSITIVE_INFINITY;
  for (;;) {
    const start = performance.now();
    const result = await run();
    best = Math.min(best, performance.now() - start);
    if (--runs <= 0) return [best, result];
  }
}

/** Returns the median time to detect plants, in milliseconds; `params` returns the options of a run. */
async function medianDetectionTime(runs: number, params: () => DetectOptions) {
  // The clock is coarse: for short clips, each run is the mean of several repeats.
  const repeats = (clip?.info().frames ?? 0) > 2000 ? 1 : 20;
  const means: number[] = [];
  for (let run = 0; run < runs; run++) {
    let sum = 0;
    for (let repeat = 0; repeat < repeats; repeat++) {
      const options = params();
      sum += (await bestTime(1, () => clip?.detect(options).free()))[0];
    }
    means.push(sum / repeats);
  }
  return means.sort((a, b) => a - b)[Math.floor(runs / 2)];
}

const bench = {
  /** Reads a clip for the other functions. Returns milliseconds, and bytes of the file and of memory. */
  async parse(url: string, runs: number) {
    const file = await (await fetch(url)).blob();
    const before = memory.buffer.byteLength;
    const [time] = await bestTime(runs, async () => {
      clip?.free();
      clip = await read(file);
    });
    clipFile = file;
    return { time, bytes: file.size, memory: memory.buffer.byteLength, before };
  },

  /** Reads a clip with three.js' loader. */
  async parseWithLoader(url: string, runs: number) {
    const text = await (await fetch(url)).text();
    const [time, parsed] = await bestTime(runs, () => new BVHLoader().parse(text));
    return { time, bytes: text.length, joints: parsed.skeleton.bones.length };
  },

  /** Truncates the clip to its first frames. */
  async truncate(frames: number) {
    if (!clip || !clipFile) throw new Error("no clip is open");
    const part = await rewriteFile(clipFile, clip.cut(0, frames));
    clip.free();
    clip = await read(part);
    clipFile = part;
    return clip.info().frames;
  },

  /** Returns the time of a first detection of all parts of both feet, in milliseconds. */
  async detect(runs: number, exact: boolean, method = "robust") {
    return medianDetectionTime(runs, () => {
      // Overrides clear the detection cache.
      clip?.override({});
      return { method, r: 0.001, w: 1, exact };
    });
  },

  /** Returns the time of a detection after a change of r, or of r and w, in milliseconds. */
  async redetect(runs: number, what: "r" | "w", method = "robust") {
    let run = 0;
    return medianDetectionTime(runs, () => {
      run++;
      return { method, r: 0.001 + run * 1e-5, w: what === "w" ? 1 + (run % 2) : 1 };
    });
  },

  /** Returns the input of the published method: heights and speeds of both toes, and the bandwidth. */
  toeSignals() {
    const detection = clip?.detect({ method: "paper", r: 0.001, w: 1 });
    if (!detection) throw new Error("no clip is open");
    const [heights, speeds] = (["height", "speed"] as const).map((what) =>
      ["left", "right"].map((side) => [...detection[what]("toe", side)]),
    );
    const { sigma } = detection.evidence("toe");
    detection.free();
    return { heights, speeds, sigma };
  },

  /** Returns the size of wasm memory in bytes, which never shrinks. */
  memoryBytes() {
    return memory.buffer.byteLength;
  },

  /** Returns the time of a segmentation, in milliseconds. */
  async segment(method: string, runs: number) {
    const [time] = await bestTime(runs, () => clip?.segment({ method }, () => {}).free());
    return time;
  },

  /** Returns the time to compute the positions of all joints in all frames, in milliseconds. */
  async positions(runs: number) {
    const [time] = await bestTime(runs, () => clip?.positions().length);
    return time;
  },
};

Object.assign(globalThis, { bench });
document.title = "ready";
