/** The clip and its detector, in a thread of their own. */

import * as Comlink from "comlink";
import init, {
  methods,
  type RawClip,
  type RawDetection,
  RawLabelling,
  RawReader,
} from "../wasm/plantigrade";
import type {
  Clip,
  Detection,
  DetectOptions,
  Evidence,
  Failure,
  Labelling,
  MethodFacts,
  Overrides,
  Part,
  SaveFormat,
  Score,
  Side,
  Track,
  Tracks,
} from "./types";

export type Opened = { ok: true; clip: Clip } | { ok: false; failure: Failure };
export type Detected = { ok: true; detection: Detection } | { ok: false; failure: Failure };

/** Least time between two reports of progress, in milliseconds. */
const PROGRESS_INTERVAL = 50;

const ready = init();

export type Compared = { ok: true; other: Labelling } | { ok: false; failure: Failure };

/** The file held, what was read from it, its last labels, and those of someone else. */
let held:
  | { file: Blob; name: string; clip: RawClip; detection?: RawDetection; other?: RawLabelling }
  | undefined;

const api = {
  /** Reads a clip and holds it in place of the one before; `onProgress` gets the share read, 0 … 1. */
  async open(
    file: Blob,
    name: string,
    lenient: boolean,
    onProgress?: (share: number) => void,
  ): Promise<Opened> {
    await ready;
    const opened = await refusals(async () => {
      const clip = await read(file, lenient, onProgress);
      release();
      held = { file, name, clip };
      return clip;
    });
    return opened.ok ? facts() : opened;
  },

  /** Applies overrides in place of those before; what is absent is as found. */
  async override(overrides: Overrides): Promise<Opened> {
    const applied = await refusals(() => current().clip.override(overrides));
    return applied.ok ? facts() : applied;
  },

  async detect(options: DetectOptions): Promise<Detected> {
    const detected = await refusals(() => current().clip.detect(options));
    if (!detected.ok) return detected;
    const here = current();
    here.detection?.free();
    here.detection = detected.value;
    const detection = copy(detected.value, options);
    return Comlink.transfer({ ok: true, detection }, buffers(detection));
  },

  /** All methods of detection, the default first. */
  async methods(): Promise<MethodFacts[]> {
    await ready;
    return methods();
  },

  /** Reads labels of the clip by someone else and holds them in place of those before. */
  async compare(text: string, name: string): Promise<Compared> {
    const here = current();
    const read = await refusals(() => new RawLabelling(text, here.clip.facts().frames));
    if (!read.ok) return read;
    here.other?.free();
    here.other = read.value;
    return { ok: true, other: labelling(read.value, name) };
  },

  /** How well the last detection agrees with the labels of someone else, part by part. */
  async score(): Promise<Score[]> {
    const { clip, detection, other } = current();
    return detection && other ? other.score(clip, detection) : [];
  },

  /** The labels of the last detection. */
  async save(format: SaveFormat): Promise<string> {
    const { file, name, clip, detection } = current();
    if (!detection) throw new Error("There are no labels to save.");
    return clip.save(detection, format, name, format === "json" ? await sha256(file) : undefined);
  },
};

export type Api = typeof api;

Comlink.expose(api);

function current() {
  if (!held) throw new Error("No clip is open.");
  return held;
}

function release() {
  held?.detection?.free();
  held?.other?.free();
  held?.clip.free();
  held = undefined;
}

/** What the core refuses with a reason comes back as one; anything else is a fault and is thrown. */
async function refusals<T>(
  work: () => T | Promise<T>,
): Promise<{ ok: true; value: T } | { ok: false; failure: Failure }> {
  try {
    return { ok: true, value: await work() };
  } catch (refusal) {
    if (refusal instanceof Error) throw refusal;
    return { ok: false, failure: refusal as Failure };
  }
}

async function read(
  file: Blob,
  lenient: boolean,
  onProgress?: (share: number) => void,
): Promise<RawClip> {
  const reader = new RawReader(lenient);
  let done = 0;
  let reported = performance.now();
  const chunks = file.stream().getReader();
  try {
    for (let next = await chunks.read(); !next.done; next = await chunks.read()) {
      reader.push(next.value);
      done += next.value.length;
      if (onProgress && performance.now() - reported > PROGRESS_INTERVAL) {
        reported = performance.now();
        onProgress(done / file.size);
      }
    }
  } catch (refusal) {
    reader.free();
    throw refusal;
  }
  return reader.finish();
}

function facts(): Opened {
  const { clip, name } = current();
  const positions = clip.positions();
  return Comlink.transfer({ ok: true, clip: { name, ...clip.facts(), positions } }, [
    positions.buffer,
  ]);
}

function copy(raw: RawDetection, options: DetectOptions): Detection {
  const names = raw.parts() as Part[];
  const parts = Object.fromEntries(names.map((part) => [part, tracks(raw, part)]));
  return {
    options,
    parts: parts as Detection["parts"],
    floor: raw.floor,
    notices: raw.notices(),
  };
}

function labelling(raw: RawLabelling, name: string): Labelling {
  const sides = (part: Part) => ({
    left: raw.planted(part, "left"),
    right: raw.planted(part, "right"),
  });
  const names = raw.parts() as Part[];
  return { name, parts: Object.fromEntries(names.map((part) => [part, sides(part)])) };
}

function tracks(raw: RawDetection, part: Part): Tracks {
  const track = (side: Side): Track => ({
    planted: raw.planted(part, side),
    confidence: raw.confidence(part, side),
    intervals: raw.intervals(part, side),
    height: raw.height(part, side),
    speed: raw.speed(part, side),
  });
  const both = { left: track("left"), right: track("right") };
  return raw.hasEvidence(part) ? { ...both, evidence: evidence(raw, part) } : both;
}

function evidence(raw: RawDetection, part: Part): Evidence {
  return {
    sortedNorms: raw.sortedNorms(part),
    runningVariance: raw.runningVariance(part),
    knee: raw.knee(part),
    sigma: raw.sigma(part),
    roots: raw.roots(part),
    threshold: raw.threshold(part),
  };
}

/** The memory of all series of a detection, to be handed over rather than copied. */
function buffers(detection: Detection): Transferable[] {
  const series = (record: object): Transferable[] =>
    Object.values(record).flatMap((value) => {
      if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
      return value && typeof value === "object" ? series(value) : [];
    });
  return series(detection.parts);
}

/** The file's SHA-256 in hexadecimal; unknown where the browser does not offer it. */
async function sha256(file: Blob): Promise<string | undefined> {
  if (!globalThis.crypto?.subtle) return undefined;
  const digest = await crypto.subtle.digest("SHA-256", await file.arrayBuffer());
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
