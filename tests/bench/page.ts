/**
 * Operations that `npm run bench` measures in a page: those of the wasm module and, as references,
 * three.js' loader and arithmetic at the peak of the processor. The native program
 * `plantigrade-measure` has the same operations with the same names.
 */

import { BVHLoader } from "three/examples/jsm/loaders/BVHLoader.js";
import init, {
  type DetectOptions,
  type WasmClip,
  WasmReader,
} from "../../web/src/wasm/plantigrade";
import secondModule from "../../web/src/wasm/plantigrade_second.wasm?url";
import { readChunks } from "../../web/src/workers/read-blob";
import { rewriteFile } from "../../web/src/workers/rewrite-file";

/** Minimum duration of a measurement in milliseconds; shorter operations are repeated. */
const MIN_DURATION = 20;
/** Bytes of a chunk of a file in memory, as the app reads them. */
const CHUNK_BYTES = 1 << 20;
/** Multiply-adds of the peak measurement: 48 per repeat. */
const PEAK_REPEATS = 1_000_000;

const first = await init();
await WebAssembly.instantiateStreaming(fetch(secondModule), { __wasm_split: { ...first } });
const { memory } = first;
const peak = await WebAssembly.instantiateStreaming(fetch("/peak.wasm"));
const multiplyAdds = peak.instance.exports.multiply_adds as (repeats: number) => number;

interface Opened {
  file: Blob;
  clip: WasmClip;
  /** Content for operations on files in memory, once needed. */
  bytes?: Uint8Array;
  text?: string;
}

const clips = new Map<string, Opened>();
let current: Opened | undefined;
/** Number of detections with changed parameters so far. */
let detections = 0;

function opened(): Opened {
  if (!current) throw new Error("no clip is open");
  return current;
}

/** Reads a file as the app's worker does. */
async function read(file: Blob): Promise<WasmClip> {
  const reader = new WasmReader(false, file.size);
  for await (const chunk of readChunks(file)) reader.push(chunk);
  return reader.finish();
}

/** Reads a file that is in memory. */
function readBytes(bytes: Uint8Array): WasmClip {
  const reader = new WasmReader(false, bytes.length);
  for (let start = 0; start < bytes.length; start += CHUNK_BYTES) {
    reader.push(bytes.subarray(start, start + CHUNK_BYTES));
  }
  return reader.finish();
}

/** Detects with default parameters, except for those given. */
function detect(options: Partial<DetectOptions>) {
  return opened().clip.detect({ method: "robust", r: 0.001, w: 1, exact: false, ...options });
}

/** Detects after everything that depends on the clip has been cleared. */
function detectAgain(options: Partial<DetectOptions>) {
  opened().clip.override({});
  return detect(options);
}

/** Result of an operation, released outside the measured time. */
type Result = { free(): void } | undefined;

/** The operations, by name. `prepare` runs outside the measured time. */
const operations: Record<
  string,
  { prepare?(): Promise<void>; run(argument: string): Result | Promise<Result> }
> = {
  read: {
    async prepare() {
      opened().bytes ??= new Uint8Array(await opened().file.arrayBuffer());
    },
    run: () => readBytes(opened().bytes as Uint8Array),
  },
  "read-file": { run: () => read(opened().file) },
  "bvh-loader": {
    async prepare() {
      opened().text ??= await opened().file.text();
    },
    run() {
      new BVHLoader().parse(opened().text as string);
      return undefined;
    },
  },
  positions: {
    run() {
      opened().clip.positions();
      return undefined;
    },
  },
  detect: { run: () => detectAgain({}) },
  "detect-all-pairs": { run: () => detectAgain({ exact: true }) },
  "detect-paper": { run: () => detectAgain({ method: "paper" }) },
  "detect-another-r": { run: () => detect({ r: 0.001 + 1e-5 * (++detections % 50) }) },
  "detect-another-w": { run: () => detect({ w: 1 + (++detections % 2) }) },
  "cluster-paper": {
    run: () => detect({ method: "paper", r: 0.001 + 1e-5 * (++detections % 50) }),
  },
  segment: { run: (method) => opened().clip.segment({ method }, () => {}) },
  peak: {
    run() {
      multiplyAdds(PEAK_REPEATS);
      return undefined;
    },
  },
};

const bench = {
  /** Opens a clip, or selects it if it is open. Returns its size in bytes. */
  async open(url: string) {
    current = clips.get(url);
    if (!current) {
      const file = await (await fetch(url)).blob();
      current = { file, clip: await read(file) };
      clips.set(url, current);
    }
    return current.file.size;
  },

  /** Reads a clip with three.js' loader only. */
  async load(url: string) {
    const text = await (await fetch(url)).text();
    return new BVHLoader().parse(text).skeleton.bones.length;
  },

  /** Truncates the open clip to its first frames. */
  async truncate(frames: number) {
    const { file, clip } = opened();
    const part = await rewriteFile(file, clip.cut(0, frames));
    current = { file: part, clip: await read(part) };
  },

  /** Returns the mean time of an operation on the open clip, in milliseconds. */
  async measure(name: string, argument = "") {
    const operation = operations[name];
    if (!operation) throw new Error(`There is no operation ${name}.`);
    await operation.prepare?.();
    let total = 0;
    for (let runs = 1; ; runs++) {
      const start = performance.now();
      const result = await operation.run(argument);
      total += performance.now() - start;
      result?.free();
      if (total >= MIN_DURATION) return total / runs;
    }
  },

  /** Returns the input of the published method: heights and speeds of both toes, and the bandwidth. */
  toeSignals() {
    const detection = detect({ method: "paper" });
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

  /** Returns the multiply-adds of a peak measurement. */
  peakMultiplyAdds() {
    return 48 * PEAK_REPEATS;
  },
};

Object.assign(globalThis, { bench });
document.title = "ready";
