/** What is measured in the browser: ours and the reference, in the same page. */

import { BVHLoader } from "three/examples/jsm/loaders/BVHLoader.js";
import init, {
  type DetectOptions,
  type WasmClip,
  WasmReader,
} from "../../web/src/wasm/plantigrade";
import { readChunks } from "../../web/src/workers/read-blob";

const { memory } = await init();

let clip: WasmClip | undefined;

/** Reads a file as the app's worker does. */
async function read(file: Blob): Promise<WasmClip> {
  const reader = new WasmReader(false, file.size);
  for await (const piece of readChunks(file)) reader.push(piece);
  return reader.finish();
}

/** Milliseconds that the quickest of some runs takes, and what the last gave. */
async function timed<T>(runs: number, work: () => T | Promise<T>): Promise<[number, T]> {
  let best = Number.POSITIVE_INFINITY;
  for (;;) {
    const start = performance.now();
    const result = await work();
    best = Math.min(best, performance.now() - start);
    if (--runs <= 0) return [best, result];
  }
}

/** Milliseconds that the middle one of some runs takes to label the clip, each with parameters of its own. */
async function labelled(runs: number, params: () => DetectOptions) {
  // The browser's clock is coarse: of short clips, the mean of some times counts.
  const times = (clip?.info().frames ?? 0) > 2000 ? 1 : 20;
  const means: number[] = [];
  for (let run = 0; run < runs; run++) {
    let sum = 0;
    for (let time = 0; time < times; time++) {
      const wanted = params();
      sum += (await timed(1, () => clip?.detect(wanted).free()))[0];
    }
    means.push(sum / times);
  }
  return means.sort((a, b) => a - b)[Math.floor(runs / 2)];
}

const bench = {
  /** Reads a clip and holds it; milliseconds, bytes of the file and of wasm memory. */
  async parse(url: string, runs: number) {
    const file = await (await fetch(url)).blob();
    const before = memory.buffer.byteLength;
    const [time] = await timed(runs, async () => {
      clip?.free();
      clip = await read(file);
    });
    return { time, bytes: file.size, memory: memory.buffer.byteLength, before };
  },

  /** The same by three.js' loader. */
  async loader(url: string, runs: number) {
    const text = await (await fetch(url)).text();
    const [time, parsed] = await timed(runs, () => new BVHLoader().parse(text));
    return { time, bytes: text.length, joints: parsed.skeleton.bones.length };
  },

  /** Holds the first frames of the clip only. */
  async cut(frames: number) {
    if (!clip) throw new Error("there is no clip");
    const part = new Blob([clip.cut(0, frames) as Uint8Array<ArrayBuffer>]);
    clip.free();
    clip = await read(part);
    return clip.info().frames;
  },

  /** Milliseconds to label the clip, all parts of both feet, as if for the first time. */
  async detect(runs: number, exact: boolean, method = "robust") {
    return labelled(runs, () => {
      // Overrides let go of what was kept from the time before.
      clip?.override({});
      return { method, r: 0.001, w: 1, exact };
    });
  },

  /** Milliseconds to label it anew when a slider moves: r, or r and w. */
  async relabel(runs: number, what: "r" | "w", method = "robust") {
    let run = 0;
    return labelled(runs, () => {
      run++;
      return { method, r: 0.001 + run * 1e-5, w: what === "w" ? 1 + (run % 2) : 1 };
    });
  },

  /** What the published method clusters: heights and speeds of both toes, and the scale that it finds. */
  toes() {
    const found = clip?.detect({ method: "paper", r: 0.001, w: 1 });
    if (!found) throw new Error("there is no clip");
    const [heights, speeds] = (["height", "speed"] as const).map((what) =>
      ["left", "right"].map((side) => [...found[what]("toe", side)]),
    );
    const { sigma } = found.evidence("toe");
    found.free();
    return { heights, speeds, sigma };
  },

  /** Bytes of wasm memory: the most that it ever took. */
  memory() {
    return memory.buffer.byteLength;
  },

  /** Milliseconds to cut it into actions. */
  async segment(method: string, runs: number) {
    const [time] = await timed(runs, () => clip?.segment({ method }, () => {}).free());
    return time;
  },

  /** Milliseconds to place all joints in all frames. */
  async positions(runs: number) {
    const [time] = await timed(runs, () => clip?.positions().length);
    return time;
  },
};

export type Bench = typeof bench;

Object.assign(globalThis, { bench });
document.title = "ready";
