/** Labels one file after the other, each from its bytes to what a table and an archive say of it. */

import * as Comlink from "comlink";
import { labelEndings, segmentEndings } from "../lib/endings";
import { actionsOf, type Named, titleOf } from "../lib/segments";
import { summary } from "../lib/slides";
import type { RawClip, RawDetection } from "../wasm/plantigrade";
import { buffers, copyClip, copyDetection } from "./copies";
import { read, ready, refusals, seldom, sha256, start } from "./reading";
import type {
  Clip,
  Detection,
  DetectOptions,
  Edit,
  Failure,
  SaveFormat,
  SegmentFormat,
  SegmentOptions,
} from "./types";

/** What is done with each file. */
export interface Orders {
  detect: DetectOptions;
  segment: SegmentOptions;
  /** What comes back as files, besides the facts. */
  formats: readonly SaveFormat[];
  segmentFormats: readonly SegmentFormat[];
}

/** The facts of one clip, for a table. */
export interface Survey {
  frames: number;
  /** Frames per second. */
  rate: number;
  notices: number;
  /** Plants of both feet, of the part that says best when a foot is down. */
  plants?: number;
  /** Share of the frames in which each foot is planted, 0 … 1; absent where no plants can be found. */
  planted?: { left: number; right: number };
  segments?: number;
  /** Steps per minute; absent where nobody walks or runs. */
  cadence?: number;
  /** Mean and greatest slide of a plant, in metres; absent without plants. */
  skate?: { mean: number; worst: number };
  /** Why plants or segments are missing. */
  missing: string[];
  /** Whether a person has edited its labels. */
  edited: boolean;
  /** Time that it took, in milliseconds. */
  took: number;
}

/** What a person changed in a file. */
export interface Changes {
  edits: readonly Edit[];
  names: readonly Named[];
}

/** What one file is saved as. */
export interface Document {
  /** What its name ends in. */
  ending: string;
  data: string | Uint8Array;
}

interface Refused {
  ok: false;
  failure: Failure;
}

export type Surveyed = { ok: true; survey: Survey; documents: Document[] } | Refused;

const api = {
  start,

  /**
   * Surveys one file; `changesOf` gives what a person changed in the file with that hash,
   * `onProgress` gets the share read, 0 … 1.
   */
  async survey(
    file: Blob,
    name: string,
    orders: Orders,
    changesOf: (hash: string) => Promise<Changes>,
    onProgress?: (share: number) => void,
  ): Promise<Surveyed> {
    await ready;
    const began = performance.now();
    const opened = await refusals(() => read(file, false, seldom(onProgress)));
    if (!opened.ok) return opened;
    const hash = await sha256(file);
    const changes = hash ? await changesOf(hash) : { edits: [], names: [] };
    const held: { free(): void }[] = [opened.value];
    try {
      const task = { clip: opened.value, name, hash, orders, changes, held };
      const { survey, documents } = await label(task);
      return { ok: true, survey: { ...survey, took: performance.now() - began }, documents };
    } finally {
      for (const owner of held) owner.free();
    }
  },

  /** Reads and labels a clip that is to stand beside another; without feet it has no labels. */
  async figure(
    file: Blob,
    name: string,
    options: DetectOptions,
    changesOf: (hash: string) => Promise<Changes>,
  ): Promise<Figured> {
    await ready;
    const opened = await refusals(() => read(file, false, () => {}));
    if (!opened.ok) return opened;
    const raw = opened.value;
    const hash = await sha256(file);
    const changes = hash ? await changesOf(hash) : { edits: [] };
    const detected = await refusals(() => raw.detect(options));
    if (detected.ok) detected.value.edit([...changes.edits]);
    const clip = copyClip(raw, name);
    const detection = detected.ok ? copyDetection(detected.value, options) : null;
    if (detected.ok) detected.value.free();
    raw.free();
    return Comlink.transfer({ ok: true, clip, detection }, buffers({ clip, detection }));
  },
};

export type Figured = { ok: true; clip: Clip; detection: Detection | null } | Refused;

export type SurveyApi = typeof api;

Comlink.expose(api);

interface Task {
  clip: RawClip;
  name: string;
  hash: string | undefined;
  orders: Orders;
  changes: Changes;
  /** What is to be freed in the end. */
  held: { free(): void }[];
}

async function label(task: Task): Promise<{ survey: Omit<Survey, "took">; documents: Document[] }> {
  const { clip, name, hash, orders, changes, held } = task;
  const { frames, rate, notices } = clip.facts();
  const survey: Omit<Survey, "took"> = {
    frames,
    rate,
    notices: notices.length,
    missing: [],
    edited: changes.edits.length > 0,
  };
  const documents: Document[] = [];
  const detected = await refusals(() => clip.detect(orders.detect));
  if (detected.ok) {
    const { value } = detected;
    held.push(value);
    value.edit([...changes.edits]);
    Object.assign(survey, factsOf(value, frames));
    const { cadence } = clip.gait(value);
    if (cadence !== undefined) survey.cadence = cadence;
    const skate = summary(clip.skate(value).map(({ farthest }) => farthest));
    if (skate) survey.skate = skate;
    survey.notices += value.notices().length;
    for (const format of orders.formats) {
      const data = clip.save(value, format, name, hash);
      documents.push({ ending: labelEndings[format][0], data });
    }
  } else survey.missing.push(detected.failure.message);
  const segmented = await refusals(() => clip.segment(orders.segment, () => {}));
  if (segmented.ok) {
    const { value } = segmented;
    held.push(value);
    const segments = value.segments();
    survey.segments = segments.length;
    const names = actionsOf(segments, changes.names).map(titleOf);
    for (const format of orders.segmentFormats) {
      const data = clip.saveSegments(value, names, format, name, hash);
      documents.push({ ending: segmentEndings[format][0], data });
    }
  } else survey.missing.push(segmented.failure.message);
  return { survey, documents };
}

function factsOf(detection: RawDetection, frames: number) {
  const part = detection.parts()[0] ?? "";
  const share = (side: "left" | "right") =>
    detection.planted(part, side).reduce((sum, planted) => sum + planted, 0) / frames;
  const count = (side: "left" | "right") => detection.intervals(part, side).length / 2;
  return {
    planted: { left: share("left"), right: share("right") },
    plants: count("left") + count("right"),
  };
}
