/**
 * What the worker hands to the page. Positions are metres, Y up, right-handed;
 * times are seconds; frames count from 0.
 */

import type { Digest } from "../lib/reduce";
import type {
  CleanedPlantFacts,
  ClipFacts,
  DetectOptions,
  EvidenceFacts,
  LimitFacts,
  SegmentFacts,
  SegmentOptions,
} from "../wasm/plantigrade";

export type {
  CleanedPlantFacts as CleanedPlant,
  CutScore,
  DetectOptions,
  DisagreementFacts as Disagreement,
  EditFacts as Edit,
  Failure,
  GaitFacts as Gait,
  JointFacts as Joint,
  MethodFacts,
  NoticeText as Notice,
  Overrides,
  ScoreFacts as Score,
  SegmentFacts as Segment,
  SegmentMethodFacts as SegmentMethod,
  SegmentOptions,
  SlideFacts as Slide,
} from "../wasm/plantigrade";

/** A signed axis of the file that points up. */
export type Up = ClipFacts["up"];
export type Side = "left" | "right";
export type Part = "contact" | "toe" | "heel";
/**
 * What labels are saved as: a document, tables per frame, plant and gait event, arrays for
 * NumPy, or a script for Blender.
 */
export type SaveFormat = "json" | "csv" | "intervals" | "events" | "npz" | "blender";
/** What segments are saved as: a document, a table, or the shape of BABEL. */
export type SegmentFormat = "json" | "csv" | "babel";

/** A clip as it was read, with what was found out about it. */
export interface Clip extends ClipFacts {
  name: string;
  /** max(frames, 1) × joints × 3; the rest pose where there is no motion. */
  positions: Float32Array;
}

/** One part (contact, toe or heel) of one foot. */
export interface Track {
  /** 0 or 1 per frame. */
  planted: Uint8Array;
  /** Probability that the label is right, per frame, 0.5 … 1. */
  confidence: Float32Array;
  /** start, end, start, end … in frames, half-open. */
  intervals: Uint32Array;
  /** For each interval 1 where it is as a person wants it, else 0. */
  edited: Uint8Array;
  /** Stretches of planted frames that are less certain than 0.75: start, end, start, end … */
  doubts: Uint32Array;
  /** Height above the ground in metres, per frame, of the signal that was clustered. */
  height: Float32Array;
  /** Speed in m/s, per frame, of the signal that was clustered. */
  speed: Float32Array;
  /** What the curves of both are drawn by. */
  digests: Record<"height" | "speed", Digest>;
}

/** What of a track an edit changes. */
export type Labels = Pick<Track, "planted" | "confidence" | "intervals" | "edited" | "doubts">;

export interface Tracks {
  left: Track;
  right: Track;
}

export interface Detection {
  /** The options it was made with. */
  options: DetectOptions;
  /** Methods label some of the parts: contact, toe and heel, or toe alone, or contact alone. */
  parts: Partial<Record<Part, Tracks>>;
  /** Height of the ground in the clip's positions, metres: subtract it from y. */
  floor: number;
  notices: NoticeList;
}

/** A height in metres and a speed in m/s. */
export interface Place {
  height: number;
  speed: number;
}

/** Why feet are taken for planted. */
export interface Why {
  part: Part;
  /** What heights and speeds are compared with, where the method does that. */
  limits: LimitFacts;
  /** How the samples were clustered, where they were. */
  evidence?: Evidence;
}

/** A clustering of the samples of both feet: u parts them at a threshold. */
export interface Evidence extends EvidenceFacts {
  /** Number of samples. */
  count: number;
  /** Places among the norms in ascending order, evenly spread, with the knee's. */
  ranks: Float32Array;
  /** The norm at each of them. */
  norms: Float32Array;
  /** The variance of the norms up to each of them. */
  variances: Float32Array;
  /** Norm and u of each frame of the clip; not a number where a frame was not clustered. */
  feet: Record<Side, { norms: Float32Array; roots: Float32Array }>;
  /** What u a foot would have; absent where only the clip's own samples have one. */
  field?: Field;
}

/** u of feet that hold a height and a speed, on a grid whose steps grow with the height and the speed. */
export interface Field {
  /** The greatest height and speed of the grid. */
  reach: Place;
  /** Steps to a side; place i of a side lies at (i / (size − 1))² of the greatest. */
  size: number;
  /** size × size, by rows of one height. */
  roots: Float32Array;
}

/** What a method of segmentation looks at. */
export interface Curve {
  title: string;
  /** Where the values lie: frames with fractions, ascending. */
  frames: Float32Array;
  values: Float32Array;
  /** What each value was compared with; empty where there is no such threshold. */
  threshold: Float32Array;
  /** Indices of the values at which the curve turns, where that matters. */
  extrema: Uint32Array;
}

export interface Segmentation {
  /** The options it was made with. */
  options: SegmentOptions;
  /** In order; they tile the clip. */
  segments: readonly SegmentFacts[];
  /** Frames in which one action goes over into the next: start, end, start, end …, half-open. */
  transitions: Uint32Array;
  /** The pieces of motion between turning points: start, end, start, end …, half-open. */
  motifs: Uint32Array;
  /** The class of each motif, from 1: those that are alike have the same. */
  classes: Uint32Array;
  curve: Curve;
  notices: NoticeList;
}

/** Labels of the clip by someone else: 1 planted, 0 not, −1 not known, per frame. */
export interface Labelling {
  name: string;
  parts: Partial<Record<Part, Record<Side, Int8Array>>>;
}

/** Segments of the clip by someone else; they tile it. */
export interface Segments {
  name: string;
  segments: readonly SegmentFacts[];
}

/** The clip with its planted feet held still. */
export interface Cleaned {
  /** As those of the clip. */
  positions: Float32Array;
  /** What became of every plant: the left foot's, then the right's. */
  plants: readonly CleanedPlantFacts[];
  notices: NoticeList;
}

type NoticeList = ClipFacts["notices"];
