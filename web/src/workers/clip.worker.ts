/** Holds the open clip, its detection and its segmentation. */

import * as Comlink from "comlink";
import type {
  Annotation,
  CleanedClip,
  Clip,
  ClipPart,
  CutEdit,
  CutScore,
  Detection,
  DetectionMethod,
  DetectOptions,
  Edit,
  EditedParts,
  Evidence,
  FileFormat,
  FootFrames,
  Gait,
  GaitAction,
  HeightSpeed,
  OnProgress,
  Overrides,
  Part,
  Result,
  Score,
  Segment,
  SegmentAnnotation,
  Segmentation,
  SegmentationMethod,
  SegmentOptions,
  Similar,
  Slide,
} from "../model/types";
import {
  gaitFormats,
  hasSegments,
  methods,
  plantFormats,
  segmentFormats,
  segmentMethods,
  WasmAnnotation,
  type WasmCleanedClip,
  type WasmClip,
  type WasmDetection,
  WasmSegmentAnnotation,
  type WasmSegmentation,
} from "../wasm/plantigrade";
import { evidenceToPlain } from "./evidence-to-plain";
import { holdLock } from "./hold-lock";
import { rewriteFile } from "./rewrite-file";
import {
  annotationToPlain,
  clipToPlain,
  detectionToPlain,
  labelsToPlain,
  segmentationToPlain,
  transferables,
} from "./to-plain";
import {
  methodReady,
  readClip,
  sha256,
  startSecondModule,
  startWasm,
  throttle,
  toResult,
  wasmReady,
  withSecondModule,
} from "./wasm-runtime";
import { ZipWriter } from "./zip-writer";

export type Opened = Result<{ clip: Clip }>;
export type Detected = Result<{ detection: Detection }>;
export type Segmented = Result<{ segmentation: Segmentation }>;
export type Compared = Result<{ annotation: Annotation } | { segments: SegmentAnnotation }>;

/** The open file and everything computed from it. */
interface OpenClip {
  file: Blob;
  name: string;
  clip: WasmClip;
  /** Edits that are applied to every detection. */
  edits: Edit[];
  hash?: Promise<string | undefined>;
  detection?: WasmDetection;
  /** Discarded when the labels change. */
  cleaned?: WasmCleanedClip;
  segmentation?: WasmSegmentation;
  annotation?: WasmAnnotation;
  segmentAnnotation?: WasmSegmentAnnotation;
  /** Settles when all calls have ended that use the clip after waiting; it is not freed before. */
  uses?: Promise<unknown>;
}

let openClip: OpenClip | undefined;

const api = {
  holdLock,
  startWasm,
  startSecondModule,

  /** Reads a clip and replaces the open one if it succeeds. */
  async open(file: Blob, name: string, lenient: boolean, onProgress?: OnProgress): Promise<Opened> {
    await wasmReady;
    const opened = await toResult(async () => {
      const clip = await readClip(file, lenient, throttle(onProgress));
      void release();
      openClip = { file, name, clip, edits: [] };
      return clip;
    });
    return opened.ok ? openedClip() : opened;
  },

  /** Replaces all overrides; absent fields stay as detected. */
  async override(overrides: Overrides): Promise<Opened> {
    const applied = await toResult(() => current().clip.override(overrides));
    return applied.ok ? openedClip() : applied;
  },

  /** Detects the plants and applies the edits. */
  async detect(options: DetectOptions): Promise<Detected> {
    await methodReady(options);
    const detected = await toResult(() => current().clip.detect(options));
    if (!detected.ok) return detected;
    const open = current();
    detected.value.edit(open.edits);
    open.detection?.free();
    open.detection = detected.value;
    discardCleaned(open);
    const detection = detectionToPlain(detected.value, options);
    return Comlink.transfer({ ok: true, detection }, transferables(detection.parts));
  },

  /** Replaces the edits of this and every later detection. */
  async edit(edits: Edit[]): Promise<EditedParts> {
    const open = current();
    open.edits = edits;
    const { detection } = open;
    if (!detection) return {};
    detection.edit(edits);
    discardCleaned(open);
    const names = detection.parts() as Part[];
    const sides = (part: Part) => ({
      left: labelsToPlain(detection, part, "left"),
      right: labelsToPlain(detection, part, "right"),
    });
    const parts = Object.fromEntries(names.map((part) => [part, sides(part)]));
    return Comlink.transfer(parts, transferables(parts));
  },

  /** Returns the evidence of a part; `max` is the largest height and speed of interest. */
  async evidence(part: Part, max: HeightSpeed): Promise<Evidence | undefined> {
    const { detection } = current();
    if (!detection?.parts().includes(part)) return undefined;
    const evidence = evidenceToPlain(detection, part, max);
    return Comlink.transfer(evidence, transferables(evidence));
  },

  /** Returns the edits that give the detection the labels of the reference. */
  async referenceEdits(): Promise<Edit[]> {
    return current().annotation?.edits() ?? [];
  },

  /** Returns the changes by which the edits apply to similar motion; undefined without labels. */
  async similar(): Promise<Similar | undefined> {
    const { clip, detection, edits } = current();
    return detection && clip.similar(detection, edits);
  },

  /** Returns the SHA-256 of the file in hexadecimal, if the browser offers it. */
  async hash(): Promise<string | undefined> {
    return hashOf(current());
  },

  /** Segments the clip into actions. */
  async segment(options: SegmentOptions, onProgress?: OnProgress): Promise<Segmented> {
    const report = throttle(onProgress);
    const segmented = await toResult(() => current().clip.segment(options, report));
    if (!segmented.ok) return segmented;
    const open = current();
    open.segmentation?.free();
    open.segmentation = segmented.value;
    const segmentation = segmentationToPlain(segmented.value, options);
    return Comlink.transfer({ ok: true, segmentation }, transferables(segmentation));
  },

  /** Returns all segmentation methods, the default first. */
  async segmentMethods(): Promise<SegmentationMethod[]> {
    await wasmReady;
    return segmentMethods();
  },

  /** Returns all file formats of plants, the default first. */
  async plantFormats(): Promise<FileFormat[]> {
    await wasmReady;
    return plantFormats();
  },

  /** Returns all file formats of segments, the default first. */
  async segmentFormats(): Promise<FileFormat[]> {
    await wasmReady;
    return segmentFormats();
  },

  /** Returns all file formats of gait, the default first. */
  async gaitFormats(): Promise<FileFormat[]> {
    await wasmReady;
    return gaitFormats();
  },

  /** Returns all detection methods, the default first. */
  async methods(): Promise<DetectionMethod[]> {
    await wasmReady;
    return methods();
  },

  /** Reads reference labels or segments and replaces those of the same kind. */
  async compare(file: Blob, name: string): Promise<Compared> {
    return useClip(async (open) => {
      const clipName = stem(open.name);
      const text = (await isArchive(file)) ? "" : await file.text();
      if (hasSegments(text, clipName)) {
        const read = await toResult(() => new WasmSegmentAnnotation(text, clipName, open.clip));
        if (!read.ok) return read;
        open.segmentAnnotation?.free();
        open.segmentAnnotation = read.value;
        return { ok: true, segments: { name, segments: read.value.segments() } };
      }
      const bytes = new Uint8Array(await file.arrayBuffer());
      const read = await toResult(() => new WasmAnnotation(bytes, open.clip.info().frames));
      if (!read.ok) return read;
      open.annotation?.free();
      open.annotation = read.value;
      return { ok: true, annotation: annotationToPlain(read.value, name) };
    });
  },

  /**
   * Returns gait measures from the edited labels, of the whole clip or of ranges of frames (start, end,
   * start, end, …); undefined without labels.
   */
  async gait(frames: number[] | undefined): Promise<Gait | undefined> {
    const { clip, detection } = current();
    return detection && clip.gait(detection, frames);
  },

  /** Returns the gait of the whole clip, or of each action if there are any, as a file. */
  async saveGait(actions: GaitAction[], format: string): Promise<string> {
    return useClip(async (open) => {
      const hash = await hashOf(open);
      const { name, clip, detection } = open;
      if (!detection) throw new Error("There are no labels to measure.");
      return clip.saveGait(detection, actions, format, name, hash);
    });
  },

  /** Returns the slide of every plant: those of the left foot, then those of the right. */
  async skate(): Promise<Slide[]> {
    const { clip, detection } = current();
    return detection ? clip.skate(detection) : [];
  },

  /** Removes foot skate of all plants, or of some; the result can be saved until the labels change. */
  async clean(keepSpikes: boolean, only: FootFrames[]): Promise<CleanedClip> {
    const open = current();
    if (!open.detection) throw new Error("The clean-up requires labels.");
    discardCleaned(open);
    const cleaned = open.clip.clean(open.detection, keepSpikes, only);
    open.cleaned = cleaned;
    const positions = cleaned.positions() as Float32Array<ArrayBuffer>;
    const plain = { positions, plants: cleaned.plants(), notices: cleaned.notices() };
    return Comlink.transfer(plain, [positions.buffer]);
  },

  /** Returns the cleaned clip as a BVH file. */
  async saveCleaned(keepSpikes: boolean, only: FootFrames[]): Promise<Blob> {
    const open = current();
    if (!open.detection) throw new Error("The clean-up requires labels.");
    open.cleaned ??= open.clip.clean(open.detection, keepSpikes, only);
    return rewriteFile(open.file, open.cleaned.rewriter());
  },

  /** Applies edits of the cuts, replacing earlier ones; returns the segments. */
  async editCuts(edits: CutEdit[]): Promise<Segment[]> {
    const { segmentation } = current();
    if (!segmentation) throw new Error("There are no segments.");
    segmentation.editCuts(edits);
    return segmentation.segments();
  },

  /** Returns the agreement of the detection with the reference, part by part. */
  async score(): Promise<Score[]> {
    const { clip, detection, annotation } = current();
    return detection && annotation ? annotation.score(clip, detection) : [];
  },

  /** Returns the agreement of the cuts with those of the reference. */
  async scoreSegments(): Promise<CutScore[]> {
    const { clip, segmentation, segmentAnnotation } = current();
    return segmentation && segmentAnnotation ? segmentAnnotation.score(clip, segmentation) : [];
  },

  /** Returns the segments under the given names and letters of actions, in order, as a file. */
  async saveSegments(
    format: string,
    names: string[],
    actions: string[],
  ): Promise<Uint8Array<ArrayBuffer>> {
    return useClip(async (open) => {
      const hash = await hashOf(open);
      const { name, clip, segmentation } = open;
      if (!segmentation) throw new Error("There are no segments to save.");
      const file = clip.saveSegments(segmentation, names, actions, format, name, hash);
      return file as Uint8Array<ArrayBuffer>;
    });
  },

  /** Writes parts of the clip as BVH files into a zip archive. */
  async cut(parts: readonly ClipPart[], onProgress?: OnProgress): Promise<Blob> {
    return useClip(async ({ file, clip }) => {
      const report = throttle(onProgress);
      const zip = new ZipWriter();
      // One at a time, as all texts together might not fit into memory.
      for (const [i, { name, start, end }] of parts.entries()) {
        const part = await rewriteFile(file, clip.cut(start, end));
        zip.add(name, new Uint8Array(await part.arrayBuffer()));
        report((i + 1) / parts.length);
      }
      return zip.finish();
    });
  },

  /** Returns the labels as a file. */
  async save(format: string): Promise<Uint8Array<ArrayBuffer>> {
    return useClip(async (open) => {
      const hash = await hashOf(open);
      const { name, clip, detection } = open;
      if (!detection) throw new Error("There are no labels to save.");
      return clip.save(detection, format, name, hash) as Uint8Array<ArrayBuffer>;
    });
  },
};

export type ClipApi = typeof api;

/** Calls that the first module implements. The detection waits for the second one itself. */
const firstCalls: readonly (keyof ClipApi)[] = [
  "holdLock",
  "startWasm",
  "startSecondModule",
  "open",
  "detect",
  "hash",
  "methods",
  "segmentMethods",
  "plantFormats",
  "segmentFormats",
  "gaitFormats",
];

Comlink.expose(withSecondModule(api, firstCalls, () => openClip));

function current(): OpenClip {
  if (!openClip) throw new Error("No clip is open.");
  return openClip;
}

/** Makes a call that uses the open clip after waiting, even if another clip is opened meanwhile. */
function useClip<T>(call: (open: OpenClip) => Promise<T>): Promise<T> {
  const open = current();
  const result = call(open);
  open.uses = Promise.allSettled([open.uses, result]);
  return result;
}

function discardCleaned(open: OpenClip) {
  open.cleaned?.free();
  delete open.cleaned;
}

async function release() {
  const open = openClip;
  openClip = undefined;
  await open?.uses;
  open?.detection?.free();
  open?.cleaned?.free();
  open?.segmentation?.free();
  open?.annotation?.free();
  open?.segmentAnnotation?.free();
  open?.clip.free();
}

async function isArchive(file: Blob) {
  return (await file.slice(0, 2).text()) === "PK";
}

/** Returns a file name without its extension. */
const stem = (name: string) => name.replace(/\.\w+$/, "");

function openedClip(): Opened {
  const { clip, name } = current();
  const plain = clipToPlain(clip, name);
  return Comlink.transfer({ ok: true, clip: plain }, transferables(plain));
}

function hashOf(open: OpenClip): Promise<string | undefined> {
  open.hash ??= sha256(open.file);
  return open.hash;
}
