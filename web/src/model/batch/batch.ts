/** Requests to the batch worker, and its results. */

import type { AnyEdit } from "../segments/cut-edits";
import type { SegmentName, Vocabulary } from "../segments/segments";
import type { DetectOptions, SegmentOptions } from "../types";

/** Computation requested for each file of a batch. */
export interface BatchRequest {
  detect: DetectOptions;
  segment: SegmentOptions;
  /** True to replace values that are not numbers by those of the previous frame. */
  lenient?: boolean;
  /** True to return plants and segments as files, in all formats. */
  save: boolean;
  /** Letters and names of actions in the files; without them, letters are those of the clip. */
  vocabulary?: Vocabulary;
}

/** Summary of one clip, for a row of the table. */
export interface ClipSummary {
  frames: number;
  /** Frame rate, in Hz. */
  rate: number;
  /** Number of notices. */
  notices: number;
  /** Number of plants of the principal part of both feet. */
  plants?: number;
  /** Fraction of frames in which each foot is planted, 0 to 1; absent without detection. */
  planted?: { left: number; right: number };
  /** Confidence of the least certain plant, 0.5 to 1; absent without plants. */
  confidence?: number;
  /** Number of plants of low confidence that are not edited. */
  uncertain?: number;
  /** Fraction of frames that agree with the labels dropped with the clip, within 0.1 s. */
  agreement?: number;
  /** Number of segments. */
  segments?: number;
  /** Actions of the segments; absent without segments. */
  actions?: ActionSummary;
  /** Steps per minute; absent without gait. */
  cadence?: number;
  /** Mean and largest slide of a plant, in metres; absent without plants. */
  skate?: { mean: number; worst: number };
  /** Reasons why plants or segments are missing. */
  missing: string[];
  /** True if the user has edited the labels. */
  edited: boolean;
  /** True if the browser has edits of the clip that cannot be read. */
  hasUnreadableEdits?: boolean;
  /** Processing time, in milliseconds. */
  elapsedMs: number;
}

/** Actions of one clip. */
export interface ActionSummary {
  /** Letters in the clip, in order of first appearance. */
  letters: readonly string[];
  /** Movements of the actions, by which they are found in other clips. */
  movements: Float32Array;
  /** Names that the user gave, by the letter in the clip. */
  names: ReadonlyMap<string, string>;
}

/** Edits and names that the browser has stored for a file. */
export interface StoredChanges {
  edits: readonly AnyEdit[];
  names: readonly SegmentName[];
  /** True if there are others that cannot be read. */
  isUnreadable?: boolean;
}

/** A file to be saved. */
export interface SavedFile {
  /** File extension, without the leading dot. */
  extension: string;
  data: Uint8Array;
}
