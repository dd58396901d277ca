/** The clip and its detector, in a thread of their own. */

import * as Comlink from "comlink";
import {
  hasSegments,
  methods,
  type RawCleaned,
  type RawClip,
  type RawDetection,
  RawLabelling,
  type RawSegmentation,
  RawSegments,
  segmentMethods,
} from "../wasm/plantigrade";
import { buffers, copyClip, copyDetection, copyLabels } from "./copies";
import { whyOf } from "./evidence";
import { Packing } from "./packing";
import { read, ready, refusals, seldom, sha256, start } from "./reading";
import type {
  Cleaned,
  Clip,
  CutScore,
  Detection,
  DetectOptions,
  Edit,
  Failure,
  Gait,
  Labelling,
  Labels,
  MethodFacts,
  Overrides,
  Part,
  Place,
  SaveFormat,
  Score,
  Segmentation,
  SegmentFormat,
  SegmentMethod,
  SegmentOptions,
  Segments,
  Side,
  Slide,
  Why,
} from "./types";

export type Opened = { ok: true; clip: Clip } | { ok: false; failure: Failure };
export type Detected = { ok: true; detection: Detection } | { ok: false; failure: Failure };
export type Segmented = { ok: true; segmentation: Segmentation } | { ok: false; failure: Failure };

export type Compared =
  | { ok: true; other: Labelling }
  | { ok: true; segments: Segments }
  | { ok: false; failure: Failure };

/** The labels that edits leave, of every part that was detected. */
export type EditedParts = Partial<Record<Part, Record<Side, Labels>>>;

/** A part of the clip that becomes a file: frames half-open. */
export interface CutPart {
  name: string;
  start: number;
  end: number;
}

/** The file held, what was read from it, its last labels and segments, and those of someone else. */
interface Held {
  file: Blob;
  name: string;
  clip: RawClip;
  /** What a person corrected in the labels: it lies over every detection. */
  edits: Edit[];
  hash?: Promise<string | undefined>;
  detection?: RawDetection;
  cleaned?: RawCleaned;
  segmentation?: RawSegmentation;
  other?: RawLabelling;
  otherSegments?: RawSegments;
}

let held: Held | undefined;

const api = {
  start,

  /** Reads a clip and holds it in place of the one before; `onProgress` gets the share read, 0 … 1. */
  async open(
    file: Blob,
    name: string,
    lenient: boolean,
    onProgress?: (share: number) => void,
  ): Promise<Opened> {
    await ready;
    const opened = await refusals(async () => {
      const clip = await read(file, lenient, seldom(onProgress));
      release();
      held = { file, name, clip, edits: [] };
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
    detected.value.edit(here.edits);
    here.detection?.free();
    here.detection = detected.value;
    dropCleaned(here);
    const detection = copyDetection(detected.value, options);
    return Comlink.transfer({ ok: true, detection }, buffers(detection.parts));
  },

  /** Lays edits over this and every later detection, in place of those before. */
  async edit(edits: Edit[]): Promise<EditedParts> {
    const here = current();
    here.edits = edits;
    const { detection } = here;
    if (!detection) return {};
    detection.edit(edits);
    dropCleaned(here);
    const names = detection.parts() as Part[];
    const sides = (part: Part) => ({
      left: copyLabels(detection, part, "left"),
      right: copyLabels(detection, part, "right"),
    });
    const parts = Object.fromEntries(names.map((part) => [part, sides(part)]));
    return Comlink.transfer(parts, buffers(parts));
  },

  /** Why the last detection has the feet planted; `reach` is how far heights and speeds are of interest. */
  async why(part: Part, reach: Place): Promise<Why | undefined> {
    const { detection } = current();
    if (!detection?.parts().includes(part)) return undefined;
    const why = whyOf(detection, part, reach);
    return Comlink.transfer(why, buffers(why));
  },

  /** The labels of someone else as edits that make them one's own. */
  async theirs(): Promise<Edit[]> {
    return current().other?.edits() ?? [];
  },

  /** The SHA-256 of the file in hexadecimal; unknown where the browser does not offer it. */
  async hash(): Promise<string | undefined> {
    return hashOf(current());
  },

  /** Cuts the clip into actions; `onProgress` gets the share done, 0 … 1. */
  async segment(options: SegmentOptions, onProgress?: (share: number) => void): Promise<Segmented> {
    const report = seldom(onProgress);
    const segmented = await refusals(() => current().clip.segment(options, report));
    if (!segmented.ok) return segmented;
    const here = current();
    here.segmentation?.free();
    here.segmentation = segmented.value;
    const segmentation = copySegments(segmented.value, options);
    return Comlink.transfer({ ok: true, segmentation }, buffers(segmentation));
  },

  /** All methods of segmentation, the default first. */
  async segmentMethods(): Promise<SegmentMethod[]> {
    await ready;
    return segmentMethods();
  },

  /** All methods of detection, the default first. */
  async methods(): Promise<MethodFacts[]> {
    await ready;
    return methods();
  },

  /** Reads labels or segments of the clip by someone else and holds them in place of those before. */
  async compare(file: Blob, name: string): Promise<Compared> {
    const here = current();
    const about = stem(here.name);
    const text = (await isArchive(file)) ? "" : await file.text();
    if (hasSegments(text, about)) {
      const read = await refusals(() => new RawSegments(text, about, here.clip));
      if (!read.ok) return read;
      here.otherSegments?.free();
      here.otherSegments = read.value;
      return { ok: true, segments: { name, segments: read.value.segments() } };
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    const read = await refusals(() => new RawLabelling(bytes, here.clip.facts().frames));
    if (!read.ok) return read;
    here.other?.free();
    here.other = read.value;
    return { ok: true, other: labelling(read.value, name) };
  },

  /** How the person walks, by the last labels as they are edited; nothing where there are none. */
  async gait(): Promise<Gait | undefined> {
    const { clip, detection } = current();
    return detection && clip.gait(detection);
  },

  /** How far every plant slides: the left foot's, then the right's. */
  async skate(): Promise<Slide[]> {
    const { clip, detection } = current();
    return detection ? clip.skate(detection) : [];
  },

  /** Holds the planted feet still; what comes of it can be saved until the labels change. */
  async clean(): Promise<Cleaned> {
    const here = current();
    if (!here.detection) throw new Error("There are no labels to clean by.");
    dropCleaned(here);
    const cleaned = here.clip.clean(here.detection);
    here.cleaned = cleaned;
    const positions = cleaned.positions() as Float32Array<ArrayBuffer>;
    const facts = { positions, plants: cleaned.plants(), notices: cleaned.notices() };
    return Comlink.transfer(facts, [positions.buffer]);
  },

  /** The clip as it was cleaned last, as a BVH file. */
  async saveCleaned(): Promise<Blob> {
    const here = current();
    if (!here.detection) throw new Error("There are no labels to clean by.");
    here.cleaned ??= here.clip.clean(here.detection);
    return new Blob([here.cleaned.bvh() as Uint8Array<ArrayBuffer>], { type: "text/plain" });
  },

  /** How well the last detection agrees with the labels of someone else, part by part. */
  async score(): Promise<Score[]> {
    const { clip, detection, other } = current();
    return detection && other ? other.score(clip, detection) : [];
  },

  /** How well the cuts of the last segmentation agree with those of someone else. */
  async scoreSegments(): Promise<CutScore[]> {
    const { clip, segmentation, otherSegments } = current();
    return segmentation && otherSegments ? otherSegments.score(clip, segmentation) : [];
  },

  /** The segments of the last segmentation, under the names that are given, in order. */
  async saveSegments(format: SegmentFormat, names: string[]): Promise<string> {
    const here = current();
    const { name, clip, segmentation } = here;
    if (!segmentation) throw new Error("There are no segments to save.");
    const hash = format === "json" ? await hashOf(here) : undefined;
    return clip.saveSegments(segmentation, names, format, name, hash);
  },

  /** Writes parts of the clip as files of their own into one zip archive. */
  async cut(parts: readonly CutPart[], onProgress?: (share: number) => void): Promise<Blob> {
    const { clip } = current();
    const report = seldom(onProgress);
    const packing = new Packing();
    // One after the other: all texts at once might be more than there is room for.
    for (const [i, { name, start, end }] of parts.entries()) {
      packing.add(name, clip.cut(start, end));
      report((i + 1) / parts.length);
    }
    return packing.finish();
  },

  /** The labels of the last detection. */
  async save(format: SaveFormat): Promise<Uint8Array<ArrayBuffer>> {
    const here = current();
    const { name, clip, detection } = here;
    if (!detection) throw new Error("There are no labels to save.");
    const hash = format === "json" ? await hashOf(here) : undefined;
    return clip.save(detection, format, name, hash) as Uint8Array<ArrayBuffer>;
  },
};

export type Api = typeof api;

Comlink.expose(api);

function current() {
  if (!held) throw new Error("No clip is open.");
  return held;
}

/** Labels have changed: what was cleaned by others is no longer asked for. */
function dropCleaned(here: Held) {
  here.cleaned?.free();
  delete here.cleaned;
}

function release() {
  held?.detection?.free();
  held?.cleaned?.free();
  held?.segmentation?.free();
  held?.other?.free();
  held?.otherSegments?.free();
  held?.clip.free();
  held = undefined;
}

async function isArchive(file: Blob) {
  return (await file.slice(0, 2).text()) === "PK";
}

/** A file's name without its ending. */
const stem = (name: string) => name.replace(/\.\w+$/, "");

function facts(): Opened {
  const { clip, name } = current();
  const copied = copyClip(clip, name);
  return Comlink.transfer({ ok: true, clip: copied }, buffers(copied));
}

function copySegments(raw: RawSegmentation, options: SegmentOptions): Segmentation {
  return {
    options,
    segments: raw.segments(),
    transitions: raw.transitions(),
    motifs: raw.motifs(),
    classes: raw.motifClasses(),
    curve: {
      title: raw.curveTitle(),
      frames: raw.curveFrames(),
      values: raw.curveValues(),
      threshold: raw.curveThreshold(),
      extrema: raw.extrema(),
    },
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

function hashOf(here: Held): Promise<string | undefined> {
  here.hash ??= sha256(here.file);
  return here.hash;
}
