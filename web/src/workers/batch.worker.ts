/** Processes files one at a time: summaries for the table, and clips to be shown as companions. */

import * as Comlink from "comlink";
import type {
  ActionSummary,
  BatchRequest,
  ClipSummary,
  SavedFile,
  StoredChanges,
} from "../model/batch/batch";
import { minPlantConfidence } from "../model/plants/plants";
import { summarizeSlides } from "../model/plants/slides";
import { cutEditsOf, plantEditsOf } from "../model/segments/cut-edits";
import { nameSegments, namesOfActions, segmentTitle } from "../model/segments/segments";
import type { Clip, Detection, DetectOptions, OnProgress, Result } from "../model/types";
import {
  commonActions,
  plantFormats,
  segmentFormats,
  WasmAnnotation,
  type WasmClip,
  type WasmDetection,
} from "../wasm/plantigrade";
import { holdLock } from "./hold-lock";
import { loadSmall } from "./read-blob";
import { clipToPlain, detectionToPlain, transferables } from "./to-plain";
import {
  methodReady,
  readClip,
  secondReady,
  sha256,
  startSecondModule,
  startWasm,
  throttle,
  toResult,
  wasmReady,
} from "./wasm-runtime";

export type BatchResult = Result<{ summary: ClipSummary; files: SavedFile[] }>;
export type CompanionResult = Result<{ clip: Clip; detection: Detection | null }>;

/** Returns the edits and names stored for the file with that hash. */
type ChangesOf = (hash: string) => Promise<StoredChanges>;

const api = {
  holdLock,
  startWasm,
  startSecondModule,

  /** Detects and segments one file, and returns its summary and the requested files. */
  async summarize(
    file: Blob,
    name: string,
    request: BatchRequest,
    labels: readonly Blob[],
    changesOf: ChangesOf,
    onProgress?: OnProgress,
  ): Promise<BatchResult> {
    await secondReady();
    const started = performance.now();
    const data = await loadSmall(file);
    const lenient = request.lenient ?? false;
    const opened = await toResult(() => readClip(data, lenient, throttle(onProgress)));
    if (!opened.ok) return opened;
    const hash = await sha256(data);
    const changes = hash ? await changesOf(hash) : { edits: [], names: [] };
    const owned: { free(): void }[] = [opened.value];
    try {
      const task = { clip: opened.value, name, hash, request, labels, changes, owned };
      const { summary, files } = await summarizeClip(task);
      const elapsedMs = performance.now() - started;
      return { ok: true, summary: { ...summary, elapsedMs }, files };
    } finally {
      for (const object of owned) object.free();
    }
  },

  /** Returns for each action of several clips, by its letter in the clip, a letter that equal actions share. */
  async commonActions(
    clips: readonly (ActionSummary | undefined)[],
  ): Promise<(Map<string, string> | undefined)[]> {
    await secondReady();
    const present = clips.flatMap((clip) => clip?.movements ?? []);
    const movements = new Float32Array(present.reduce((sum, { length }) => sum + length, 0));
    let end = 0;
    for (const values of present) {
      movements.set(values, end);
      end += values.length;
    }
    const names = commonActions(movements).values();
    return clips.map(
      (clip) =>
        clip && new Map(clip.letters.map((letter) => [letter, names.next().value ?? letter])),
    );
  },

  /** Reads and labels a clip that is shown next to another one. */
  async loadCompanion(
    file: Blob,
    name: string,
    lenient: boolean,
    options: DetectOptions,
    changesOf: ChangesOf,
  ): Promise<CompanionResult> {
    await wasmReady;
    const data = await loadSmall(file);
    const opened = await toResult(() => readClip(data, lenient, () => {}));
    if (!opened.ok) return opened;
    const wasmClip = opened.value;
    const hash = await sha256(data);
    const changes = hash ? await changesOf(hash) : { edits: [] };
    await methodReady(options);
    const detected = await toResult(() => wasmClip.detect(options));
    if (detected.ok && changes.edits.length) {
      await secondReady();
      detected.value.edit(plantEditsOf(changes.edits));
    }
    const clip = clipToPlain(wasmClip, name);
    const detection = detected.ok ? detectionToPlain(detected.value, options) : null;
    if (detected.ok) detected.value.free();
    wasmClip.free();
    return Comlink.transfer({ ok: true, clip, detection }, transferables({ clip, detection }));
  },
};

export type BatchApi = typeof api;

Comlink.expose(api);

interface SummaryTask {
  clip: WasmClip;
  name: string;
  hash: string | undefined;
  request: BatchRequest;
  /** Files of reference labels. */
  labels: readonly Blob[];
  changes: StoredChanges;
  /** Objects to be freed at the end. */
  owned: { free(): void }[];
}

type Summary = Omit<ClipSummary, "elapsedMs">;

async function summarizeClip(task: SummaryTask): Promise<{ summary: Summary; files: SavedFile[] }> {
  const { clip, name, hash, request, labels, changes, owned } = task;
  const { frames, rate, notices } = clip.info();
  const summary: Summary = {
    frames,
    rate,
    notices: notices.length,
    missing: [],
    edited: changes.edits.length > 0,
    ...(changes.isUnreadable && { hasUnreadableEdits: true }),
  };
  const files: SavedFile[] = [];
  const detected = await toResult(() => clip.detect(request.detect));
  if (detected.ok) {
    const { value } = detected;
    owned.push(value);
    value.edit(plantEditsOf(changes.edits));
    Object.assign(summary, plantStatistics(value, frames));
    const agreement = await agreementWith(labels, clip, value, frames);
    if (agreement !== undefined) summary.agreement = agreement;
    const { cadence } = clip.gait(value, undefined);
    if (cadence !== undefined) summary.cadence = cadence;
    const skate = summarizeSlides(clip.skate(value).map(({ maxDistance }) => maxDistance));
    if (skate) summary.skate = skate;
    summary.notices += value.notices().length;
    for (const { name: format, extension } of request.save ? plantFormats() : []) {
      files.push({ extension, data: clip.save(value, format, name, hash) });
    }
  } else summary.missing.push(detected.failure.message);
  const segmented = await toResult(() => clip.segment(request.segment, () => {}));
  if (segmented.ok) {
    const { value } = segmented;
    owned.push(value);
    const detected = value.segments();
    const letters = new Set(detected.map(({ action }) => action ?? ""));
    letters.delete("");
    value.editCuts(cutEditsOf(changes.edits));
    const segments = value.segments();
    summary.segments = segments.length;
    summary.actions = {
      letters: [...letters],
      movements: value.actionMovements(),
      names: namesOfActions(segments, changes.names, detected),
    };
    const named = nameSegments(segments, changes.names, request.vocabulary, detected);
    const names = named.map(segmentTitle);
    const actions = named.map(({ action = "" }) => action);
    for (const { name: format, extension } of request.save ? segmentFormats() : []) {
      files.push({ extension, data: clip.saveSegments(value, names, actions, format, name, hash) });
    }
  } else summary.missing.push(segmented.failure.message);
  return { summary, files };
}

function plantStatistics(detection: WasmDetection, frames: number) {
  const part = detection.parts()[0] ?? "";
  const fraction = (side: "left" | "right") =>
    detection.planted(part, side).reduce((sum, planted) => sum + planted, 0) / frames;
  const count = (side: "left" | "right") => detection.intervals(part, side).length / 2;
  const confidences = (["left", "right"] as const).flatMap((side) => {
    const edited = detection.edited(part, side);
    const means = meanOverIntervals(
      detection.intervals(part, side),
      detection.confidence(part, side),
    );
    return means.map((mean, i) => (edited[i] ? 1 : mean));
  });
  return {
    ...(confidences.length && { confidence: Math.min(...confidences) }),
    uncertain: confidences.filter((confidence) => confidence < minPlantConfidence).length,
    planted: { left: fraction("left"), right: fraction("right") },
    plants: count("left") + count("right"),
  };
}

/** Returns the mean of the values over each interval. */
function meanOverIntervals(intervals: Uint32Array, values: Float32Array): number[] {
  return Array.from({ length: intervals.length / 2 }, (_, i) => {
    const range = values.subarray(intervals[2 * i], intervals[2 * i + 1]);
    return range.reduce((sum, value) => sum + value, 0) / Math.max(1, range.length);
  });
}

/**
 * Returns the agreement with the last file that contains labels of this clip, within 0.1 s. The Score tab shows the
 * last one, too.
 */
async function agreementWith(
  labels: readonly Blob[],
  clip: WasmClip,
  detection: WasmDetection,
  frames: number,
): Promise<number | undefined> {
  for (const file of labels.toReversed()) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const read = await toResult(() => new WasmAnnotation(bytes, frames));
    if (!read.ok) continue;
    const [score] = read.value.score(clip, detection);
    read.value.free();
    const row = score?.rows.find(({ fuzzy }) => Math.abs(fuzzy - 0.1) < 1e-9);
    if (row) return row.lenient;
  }
  return undefined;
}
